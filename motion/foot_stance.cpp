#include "motion/foot_stance.h"

#include <algorithm>
#include <cmath>

#include "motion/angles.h"

namespace promenade::motion {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr double cover_seconds = 0.1;  // over which a correction comes and goes

}  // namespace

StancePhases stance_phases(const MotionSet& set, Side side) {
  const auto at = [&](std::size_t key) {
    return static_cast<int>(std::lround(set.key_phases[key] * set.phases));
  };
  if (side == Side::right) return {at(1), at(4)};
  return {at(3), at(2) + set.phases};
}

Walk make_walk(const MotionSet& set, const Cycle& cycle) {
  Walk walk{set, cycle, {}, {}, {}};
  for (int f = 0; f < set.phases; ++f) {
    const double phase = static_cast<double>(f) / set.phases;
    walk.poses.push_back(pose_at(set, cycle, phase));
    walk.worlds.push_back(forward_kinematics(set.skeleton, walk.poses.back()));
    walk.times.push_back(seconds_at(set, cycle, phase));
  }
  walk.times.push_back(cycle.seconds);
  return walk;
}

Heel heel_of(const Walk& walk, const StancePhases& stance, const LegJoints& leg) {
  int flat = stance.on;
  for (int f = stance.on; f <= stance.off; ++f) {
    if (walk.place(f, leg.ankle).y() < walk.place(flat, leg.ankle).y()) flat = f;
  }
  return find_heel(walk.place(flat, leg.ankle), walk.place(flat, leg.toe));
}

std::vector<FootStep> foot_steps(const Walk& walk, const StancePhases& stance,
                                 const LegJoints& leg) {
  const Heel heel = heel_of(walk, stance, leg);
  const auto ground = [&](int f) {
    const Vector3d ankle = walk.place(f, leg.ankle), toe = walk.place(f, leg.toe);
    Eigen::Matrix<double, 2, 3> points;
    int column = 0;
    for (const Vector3d& p : {heel_position(heel, ankle, toe), ankle, toe}) {
      points.col(column++) = Vector2d(p.x(), p.z()) + walk.time(f) * walk.cycle.velocity;
    }
    return points;
  };
  std::vector<FootStep> steps;
  for (int f = stance.on; f < stance.off; ++f) {
    const Eigen::Matrix<double, 2, 3> step = ground(f + 1) - ground(f);
    steps.push_back(
        {step.col(0).norm() < step.col(1).norm() ? step.col(0) : step.col(1), step.col(2)});
  }
  return steps;
}

std::size_t heel_off(const std::vector<FootStep>& steps) {
  double moved = 0;
  for (const FootStep& step : steps) moved += step.toe.norm();
  double least = moved;
  std::size_t best = 0;
  for (std::size_t k = 0; k < steps.size(); ++k) {
    moved += steps[k].sole.norm() - steps[k].toe.norm();
    if (moved < least) {
      least = moved;
      best = k + 1;
    }
  }
  return best;
}

Eigen::Matrix2Xd stance_shift(const std::vector<FootStep>& steps) {
  const std::size_t change = heel_off(steps);
  Eigen::Matrix2Xd shift(2, static_cast<Eigen::Index>(steps.size()) + 1);
  shift.col(0).setZero();
  for (std::size_t k = 0; k < steps.size(); ++k) {
    const auto column = static_cast<Eigen::Index>(k);
    shift.col(column + 1) = shift.col(column) - (k < change ? steps[k].sole : steps[k].toe);
  }
  const Vector2d mean = shift.rowwise().mean();
  shift.colwise() -= mean;
  return shift;
}

// Phases lie close together where both feet stand, so it is time that counts.
std::vector<double> smooth_cover(const Walk& walk, const std::vector<double>& values) {
  const int size = walk.phases();
  const auto weight = [&](int f, int g) {
    double apart = std::abs(walk.times[walk.wrapped(f)] - walk.times[walk.wrapped(g)]);
    apart = std::min(apart, walk.cycle.seconds - apart);
    return apart < cover_seconds ? 0.5 + 0.5 * std::cos(pi * apart / cover_seconds) : 0;
  };
  std::vector<double> covered(values.size(), 0), smooth(values.size(), 0);
  for (int f = 0; f < size; ++f) {
    for (int g = 0; g < size; ++g) {
      double& most = covered[walk.wrapped(f)];
      if (weight(f, g) > 0) most = std::max(most, values[walk.wrapped(g)]);
    }
  }
  for (int f = 0; f < size; ++f) {
    double sum = 0;
    for (int g = 0; g < size; ++g) {
      const double share =
          weight(f, g) * (walk.time(g + 1) - walk.time(g + size - 1) + walk.cycle.seconds);
      smooth[walk.wrapped(f)] += share * covered[walk.wrapped(g)];
      sum += share;
    }
    smooth[walk.wrapped(f)] /= sum;
  }
  return smooth;
}

}  // namespace promenade::motion
