#include "motion/motion_set.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace promenade::motion {
namespace {

// Maps x by the piecewise linear function through (from[i], to[i]), both
// ascending from 0; beyond the last knot it repeats, shifted.
double warp(const std::vector<double>& from, const std::vector<double>& to, double x) {
  assert(from.size() == to.size() && from.size() >= 2 && "keytimes and key phases go in pairs");
  const double turns = std::floor(x / from.back());
  x -= turns * from.back();
  const auto next = std::upper_bound(from.begin() + 1, from.end() - 1, x) - from.begin();
  const auto b = static_cast<std::size_t>(next);
  const double span = from[b] - from[b - 1];
  const double share = span > 0 ? (x - from[b - 1]) / span : 0;
  return turns * to.back() + to[b - 1] + share * (to[b] - to[b - 1]);
}

}  // namespace

std::vector<std::string> names_of(const MotionSet& set) {
  std::vector<std::string> names;
  names.reserve(set.cycles.size());
  for (const Cycle& cycle : set.cycles) names.push_back(cycle.name);
  return names;
}

int find_cycle(const MotionSet& set, const std::string& name) {
  for (int i = 0; i < set.size(); ++i) {
    if (set.cycles[static_cast<std::size_t>(i)].name == name) return i;
  }
  return -1;
}

double seconds_at(const MotionSet& set, const Cycle& cycle, double phase) {
  return warp(set.key_phases, cycle.keytimes, phase);
}

double phase_at(const MotionSet& set, const Cycle& cycle, double seconds) {
  return warp(cycle.keytimes, set.key_phases, seconds);
}

void pose_at(const MotionSet& set, const Cycle& cycle, double phase, Pose& pose) {
  const int joints = set.skeleton.size();
  const double position = (phase - std::floor(phase)) * set.phases;
  const int f = std::min(static_cast<int>(position), set.phases - 1);
  const int g = (f + 1) % set.phases;
  const double share = position - f;
  pose.root = (1 - share) * cycle.root.col(f) + share * cycle.root.col(g);
  pose.rotations.resize(static_cast<std::size_t>(joints));
  for (int j = 0; j < joints; ++j) {
    const Eigen::Quaterniond a(Eigen::Vector4d(cycle.rotations.col(f * joints + j)));
    const Eigen::Quaterniond b(Eigen::Vector4d(cycle.rotations.col(g * joints + j)));
    pose.rotations[static_cast<std::size_t>(j)] = a.slerp(share, b);
  }
}

Pose pose_at(const MotionSet& set, const Cycle& cycle, double phase) {
  Pose pose;
  pose_at(set, cycle, phase, pose);
  return pose;
}

}  // namespace promenade::motion
