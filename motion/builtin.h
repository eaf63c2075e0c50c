// The motion sets that the program makes itself, from a parametric gait model:
// no captured data is in them.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "motion/motion_set.h"
#include "motion/style_character.h"

namespace promenade::motion {

// "A" of "builtin:A", as people name a built-in set; nothing for any other name.
std::optional<std::string> builtin_name(std::string_view set);

// "A": ten styles of a walking human at one speed and direction ([O] 4, set A).
// "B": nine emotions of Russell's circle, each fast, normal and slow ([O] 4, set B).
// "N": 55 styles in three families, crouching, upright and wide (after [N] 5, whose map
// of 55 walks shows three clusters).
// Nothing for a name that is not there.
std::optional<MotionSet> builtin_set(std::string_view name);

// How each walk of that set was meant, in the order of its cycles; empty for a name
// that is not there.
std::vector<StyleCharacter> builtin_characters(std::string_view name);

// Names of its cycles, in their order, without making them; empty likewise.
std::vector<std::string> builtin_names(std::string_view name);

}  // namespace promenade::motion
