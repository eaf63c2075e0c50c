// An adjective model as a file: the ratings, the thresholds, how many sliders are made of them,
// and what they are called (docs/study-file.md). It holds all that it is made of and no date;
// raters are numbers.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "study/adjective_model.h"

namespace promenade::study {

// `motions`: those that must be rated, in the order wanted; empty: as the file has them. The
// pairs that it lists for each slider must be those that its ratings give. Throws InputError
// with all problems and their places. Whether the ratings agree is left to the caller.
AdjectiveModel read_adjective_model(const std::string& file, std::string_view text,
                                    const std::vector<std::string>& motions = {});

// What read_adjective_model reads. Throws InputError for ratings that do not agree.
std::string adjective_model_toml(const AdjectiveModel& model);

// By its ending; other files of ratings are tables.
bool is_adjective_model(const std::string& file);

}  // namespace promenade::study
