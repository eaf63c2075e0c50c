#include "motion/builtin.h"

namespace promenade::motion {

// Takes the place of the real one until that is there.
__attribute__((weak)) std::optional<MotionSet> builtin_set(std::string_view) { return {}; }

}  // namespace promenade::motion
