#include "motion/foot_changes.h"

#include <algorithm>
#include <cmath>

#include "motion/fade.h"
#include "motion/rotation.h"

namespace promenade::motion {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

// What is changed of a foot: rows 0 and 1 move it over the ground (left, ahead; metres),
// rows 2 to 4 turn it about its toe (a rotation vector in the world, radians).
using FootChange = Eigen::Matrix<double, 5, 1>;
using FootChanges = Eigen::Matrix<double, 5, Eigen::Dynamic>;

// A foot whose toe is held back while the ankle goes on comes up a little more: it turns
// about the toe towards where its ankle was, the more the nearer it is to leaving.
FootChanges stance_changes(const Walk& walk, const StancePhases& stance, const LegJoints& leg) {
  const std::vector<FootStep> steps = foot_steps(walk, stance, leg);
  const Eigen::Matrix2Xd shift = stance_shift(steps);
  FootChanges changes = FootChanges::Zero(5, shift.cols());
  changes.topRows<2>() = shift;
  const double middle = 0.5 * (walk.time(stance.on) + walk.time(stance.off));
  const double start = std::max(middle, walk.time(stance.on + static_cast<int>(heel_off(steps))));
  for (int f = stance.on; f <= stance.off; ++f) {
    const double x = (walk.time(f) - start) / std::max(walk.time(stance.off) - start, 1e-9);
    if (x <= 0) continue;
    const Vector3d foot = walk.place(f, leg.ankle) - walk.place(f, leg.toe);
    const Vector2d moved = shift.col(f - stance.on);
    const Eigen::Quaterniond turn =
        Eigen::Quaterniond::FromTwoVectors(foot, foot - Vector3d(moved.x(), 0, moved.y()));
    changes.col(f - stance.on).tail<3>() = x * x * (3 - 2 * x) * log_of(turn);
  }
  return changes;
}

// 5 x F: the change of one foot over the whole cycle.
FootChanges foot_changes(const Walk& walk, Side side) {
  const StancePhases stance = stance_phases(walk.set, side);
  const FootChanges stood = stance_changes(walk, stance, leg_joints(side));
  const Eigen::Index last = stood.cols() - 1;
  const int next_on = stance.on + walk.phases();
  Fade<FootChange> fade;  // from one stance to the next
  fade.seconds = walk.time(next_on) - walk.time(stance.off);
  fade.from = stood.col(last);
  fade.to = stood.col(0);
  fade.leaving =
      (stood.col(last) - stood.col(last - 1)) / (walk.time(stance.off) - walk.time(stance.off - 1));
  fade.arriving = (stood.col(1) - stood.col(0)) / (walk.time(stance.on + 1) - walk.time(stance.on));
  FootChanges changes(5, walk.phases());
  for (int f = stance.on; f < next_on; ++f) {
    changes.col(static_cast<Eigen::Index>(walk.wrapped(f))) =
        f <= stance.off ? FootChange(stood.col(f - stance.on))
                        : fade.at(walk.time(f) - walk.time(stance.off));
  }
  return changes;
}

FootTarget target_of(const Walk& walk, int f, Side side, const FootChange& change) {
  const LegJoints leg = leg_joints(side);
  const Vector3d toe = walk.place(f, leg.toe);
  const Eigen::Quaterniond turn = exp_of(change.tail<3>());
  const auto foot = static_cast<std::size_t>(walk.set.body.joint[leg.ankle]);
  return {toe + Vector3d(change(0), 0, change(1)) + turn * (walk.place(f, leg.ankle) - toe),
          turn * walk.worlds[walk.wrapped(f)].rotations[foot]};
}

// F, metres: how far the targets must come up so that neither toe nor heel is below the
// floor.
std::vector<double> lifts(const Walk& walk, Side side, const std::vector<FootTarget>& targets,
                          double floor) {
  const LegJoints leg = leg_joints(side);
  const Heel heel = heel_of(walk, stance_phases(walk.set, side), leg);
  const auto foot = static_cast<std::size_t>(walk.set.body.joint[leg.ankle]);
  std::vector<double> below;
  for (int f = 0; f < walk.phases(); ++f) {
    const FootTarget& target = targets[walk.wrapped(f)];
    const Eigen::Quaterniond turn =
        target.rotation * walk.worlds[walk.wrapped(f)].rotations[foot].conjugate();
    const Vector3d toe = target.ankle + turn * (walk.place(f, leg.toe) - walk.place(f, leg.ankle));
    const double lowest = std::min(toe.y(), heel_position(heel, target.ankle, toe).y());
    below.push_back(std::max(floor - lowest, 0.0));
  }
  return smooth_cover(walk, below);
}

}  // namespace

std::vector<FootTarget> foot_targets(const Walk& walk, Side side, double level, double floor) {
  const FootChanges changes = foot_changes(walk, side);
  std::vector<FootTarget> targets;
  for (int f = 0; f < walk.phases(); ++f) {
    targets.push_back(target_of(walk, f, side, changes.col(f)));
    targets.back().ankle.y() += floor - level;
  }
  const std::vector<double> up = lifts(walk, side, targets, floor);
  for (std::size_t f = 0; f < targets.size(); ++f) targets[f].ankle.y() += up[f];
  return targets;
}

}  // namespace promenade::motion
