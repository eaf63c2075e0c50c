// The 55 walks of the built-in set N: three families, each with variety inside. A
// walk is what its family does, some traits, and what it alone does. A style's
// family is "crouching", "upright" or "wide".
#pragma once

#include <vector>

#include "motion/gait/style.h"

namespace promenade::motion::gait {

std::vector<GaitStyle> styles_of_set_n();

}  // namespace promenade::motion::gait
