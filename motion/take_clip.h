// A take as a clip, to be written as BVH.
#pragma once

#include "motion/clip.h"
#include "motion/take.h"

namespace promenade::motion {

// In metres, Y up. Its joints have their rotations as angles about Z, Y, X, which run on from
// frame to frame; the pelvis has its place as well.
Clip take_clip(const Take& take);

}  // namespace promenade::motion
