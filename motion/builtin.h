// The motion sets that the program makes itself, from a parametric gait model:
// no captured data is in them.
#pragma once

#include <optional>
#include <string_view>

#include "motion/motion_set.h"

namespace promenade::motion {

// "A": ten styles of a walking human at one speed and direction ([O] 4, set A).
// Nothing for a name that is not there.
std::optional<MotionSet> builtin_set(std::string_view name);

}  // namespace promenade::motion
