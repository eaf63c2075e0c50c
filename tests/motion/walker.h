// A take of a generated walker, as a capture would show it: some cycles in a row, made
// from a cycle of the built-in set.
#pragma once

#include "motion/builtin.h"
#include "motion/cycle_clip.h"
#include "motion/take.h"

namespace promenade::motion {

// `change` may alter each frame's values before the file is "recorded".
inline Clip walker_clip(const MotionSet& set, const Cycle& cycle, int repeats) {
  const Clip one = cycle_clip(set, cycle);
  const int frames = one.frames() - 1;
  Clip clip = one;
  clip.file = "walker.bvh";
  clip.unit_m.reset();
  clip.values.resize(one.values.rows(), repeats * frames + 1);
  const Eigen::Vector3d travel = one.values.col(frames).head<3>() - one.values.col(0).head<3>();
  for (int f = 0; f < clip.frames(); ++f) {
    clip.values.col(f) = one.values.col(f % frames);
    clip.values.col(f).head<3>() += f / frames * travel;
  }
  return clip;
}

}  // namespace promenade::motion
