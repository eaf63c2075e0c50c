// The ten styles of the built-in set A.
#pragma once

#include <vector>

#include "motion/gait/style.h"

namespace promenade::motion::gait {

std::vector<GaitStyle> styles_of_set_a();

}  // namespace promenade::motion::gait
