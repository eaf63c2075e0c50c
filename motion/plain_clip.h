// A capture as every program understands it: turns about the axes of the joints
// themselves, multiplied from left to right.
#pragma once

#include "motion/clip.h"

namespace promenade::motion {

// The same motion without axes of its own: turns about X, Y, Z of an .asf come out as
// channels Z, Y, X, with angles that change little from frame to frame; a BVH clip stays
// as it is. Joints keep their order; positions differ by rounding alone.
Clip plain_clip(const Clip& clip);

}  // namespace promenade::motion
