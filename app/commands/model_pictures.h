// Pictures of the models that sliders are made of.
#pragma once

#include <filesystem>

#include "motion/motion_set.h"
#include "study/adjective_model.h"

namespace promenade::app {

// Write FILE.svg, FILE.pdf or FILE.png, by its ending. Throw InputError for another ending, and
// where no pair is left; OutsideError when gnuplot or the disk refuses.
void draw_adjectives(const study::AdjectiveModel& model, const std::filesystem::path& file);
void draw_features(const motion::MotionSet& set, int clusters, const std::filesystem::path& file);

}  // namespace promenade::app
