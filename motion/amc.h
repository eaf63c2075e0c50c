// Acclaim motion files (.amc): the values of one skeleton's degrees of freedom, frame
// by frame.
#pragma once

#include <string_view>

#include "motion/asf.h"

namespace promenade::motion {

// Frames a second where the file does not say (the rate of the CMU captures).
inline constexpr double usual_amc_rate = 120;

// Throws InputError with every problem found: bones that the skeleton does not have or
// that a frame lacks, wrong numbers of values, frame numbers that jump. `rate` (frames a
// second) takes the place of what the file says. Memory is bounded by the text's size.
Clip read_amc(std::string_view text, const std::string& file, const AsfSkeleton& skeleton,
              std::optional<double> rate = {});

}  // namespace promenade::motion
