// The 27 walks of the built-in set B: nine emotions of Russell's circle, each fast,
// normal and slow. A walk is made from the place of its emotion on the circle, from
// what only this emotion does, and from the tempo.
#pragma once

#include <vector>

#include "motion/gait/style.h"

namespace promenade::motion::gait {

// "excitement-fast", "excitement-normal", "excitement-slow", "pleasure-fast", ...
std::vector<GaitStyle> styles_of_set_b();

}  // namespace promenade::motion::gait
