// A take of a generated walker, as a capture would show it: some cycles in a row, made
// from a cycle of the built-in set.
#pragma once

#include <functional>

#include "motion/builtin.h"
#include "motion/cycle_clip.h"
#include "motion/take.h"

namespace promenade::motion {

inline Clip walker_clip(const MotionSet& set, const Cycle& cycle, int repeats) {
  Clip clip = repeated_clip(cycle_clip(set, cycle), repeats);
  clip.file = "walker.bvh";
  clip.unit_m.reset();
  return clip;
}

// Some cycles in a row, a take as the program reads it.
inline Take walker_take(const MotionSet& set, const Cycle& cycle, int repeats) {
  FigureOptions metres;
  metres.unit_m = 1;
  const Clip clip = walker_clip(set, cycle, repeats);
  return make_take(clip, find_figure(clip, metres));
}

// The same walk along another way: at every frame it is turned about Y by so many radians.
inline Take turned(Take take, const std::function<double(int frame)>& angle) {
  Eigen::Vector3d raw = take.poses.front().root;
  Eigen::Vector3d reached = raw;
  for (int f = 0; f < take.frames(); ++f) {
    Pose& pose = take.poses[static_cast<std::size_t>(f)];
    const Eigen::Quaterniond turn(Eigen::AngleAxisd(angle(f), Eigen::Vector3d::UnitY()));
    reached += turn * (pose.root - raw);
    raw = pose.root;
    pose.root = reached;
    pose.rotations[0] = turn * pose.rotations[0];
  }
  return take;
}

// One that stands for so many frames before and after.
inline Take standing_around(Take take, int frames) {
  take.poses.insert(take.poses.begin(), static_cast<std::size_t>(frames), take.poses.front());
  take.poses.insert(take.poses.end(), static_cast<std::size_t>(frames), take.poses.back());
  return take;
}

}  // namespace promenade::motion
