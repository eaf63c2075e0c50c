// The text of a model file, as a command or a window writes it.
#pragma once

#include <string>

#include "study/adjective_model.h"

namespace promenade::app {

// Throws InputError for ratings that do not agree, and for names that cannot be read again.
std::string model_file(const study::AdjectiveModel& model);

}  // namespace promenade::app
