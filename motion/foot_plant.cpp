#include "motion/foot_plant.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "motion/foot_changes.h"
#include "motion/foot_measures.h"

namespace promenade::motion {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

// A leg reaches at most this share of its length: a knee that comes out of a straight
// leg would snap.
constexpr double most_reach = 0.9965;
constexpr double most_speed_change = 0.04;  // of the walk's speed

Vector3d at(const Walk& walk, std::size_t f, BodyJoint part) {
  return walk.place(static_cast<int>(f), part);
}

// How far the pelvis must come down at a phase so that the leg reaches.
double lowering(const Walk& walk, std::size_t f, const LegJoints& leg, const Vector3d& ankle) {
  const Vector3d hip = at(walk, f, leg.hip), knee = at(walk, f, leg.knee);
  const double most = most_reach * ((knee - hip).norm() + (at(walk, f, leg.ankle) - knee).norm());
  const Vector3d way = ankle - hip;
  if (way.norm() <= most) return 0;
  const double across = std::hypot(way.x(), way.z());
  return -way.y() - std::sqrt(std::max(most * most - across * across, 0.0));
}

// The speed over ground at which the standing feet drift least. A foot rolls a little
// ahead while it stands, so a capture is faster than its planted feet allow; changing
// the speed of the whole walk by a few per cent spares the legs most of the work.
Vector2d speed_of_feet(const Walk& walk) {
  double drift = 0;  // ahead; a walk has no other direction
  double seconds = 0;
  for (const Side side : {Side::left, Side::right}) {
    const StancePhases stance = stance_phases(walk.set, side);
    const Eigen::Matrix2Xd shift = stance_shift(foot_steps(walk, stance, leg_joints(side)));
    drift += shift(1, 0) - shift(1, shift.cols() - 1);
    seconds += walk.time(stance.off) - walk.time(stance.on);
  }
  const double most = most_speed_change * walk.cycle.velocity.norm();
  return walk.cycle.velocity + Vector2d(0, std::clamp(-drift / seconds, -most, most));
}

// Where one foot is wanted at every phase, and about what its knee bends.
struct FootPlan {
  Side side;
  Vector3d knee;
  std::vector<FootTarget> targets;  // F
};

FootPlan plan_foot(const Walk& walk, Side side, double floor) {
  return {side, knee_axis(walk.set.skeleton, walk.set.body, side, walk.poses),
          foot_targets(walk, side, toe_level(walk.set, walk.cycle, side), floor)};
}

double most_moved(const Walk& walk, const FootPlan& plan) {
  double most = 0;
  for (std::size_t f = 0; f < plan.targets.size(); ++f) {
    const Vector3d ankle = at(walk, f, leg_joints(plan.side).ankle);
    most = std::max(most, (plan.targets[f].ankle - ankle).norm());
  }
  return most;
}

// F, metres: how far the pelvis comes down so that every foot is reached.
std::vector<double> pelvis_lowering(const Walk& walk, const std::array<FootPlan, 2>& plans) {
  std::vector<double> low(walk.poses.size(), 0);
  for (const FootPlan& plan : plans) {
    for (std::size_t f = 0; f < low.size(); ++f) {
      const LegJoints leg = leg_joints(plan.side);
      low[f] = std::max(low[f], lowering(walk, f, leg, plan.targets[f].ankle));
    }
  }
  return smooth_cover(walk, low);
}

void move_body(const std::vector<double>& low, const std::array<FootPlan, 2>& plans, Walk& walk) {
  for (std::size_t f = 0; f < low.size(); ++f) {
    walk.poses[f].root.y() -= low[f];
    for (const FootPlan& plan : plans) {
      move_foot(walk.set.skeleton, walk.set.body, plan.side, plan.knee, plan.targets[f],
                walk.poses[f]);
    }
  }
}

void store(const Walk& walk, Cycle& cycle) {
  const int joints = walk.set.skeleton.size();
  for (int f = 0; f < walk.phases(); ++f) {
    const Pose& pose = walk.poses[static_cast<std::size_t>(f)];
    cycle.root.col(f) = pose.root;
    for (int j = 0; j < joints; ++j) {
      cycle.rotations.col(f * joints + j) = pose.rotations[static_cast<std::size_t>(j)].coeffs();
    }
  }
}

}  // namespace

PlantReport plant_feet(const MotionSet& set, Cycle& cycle) {
  assert(set.walk && set.key_phases.size() == 5 && "a walk has five keytimes");
  Walk walk = make_walk(set, cycle);
  PlantReport report;
  report.speed_change = -cycle.velocity.norm();
  cycle.velocity = speed_of_feet(walk);
  report.speed_change += cycle.velocity.norm();
  const double floor = toe_level(set, cycle);
  const std::array<FootPlan, 2> plans = {plan_foot(walk, Side::left, floor),
                                         plan_foot(walk, Side::right, floor)};
  for (const FootPlan& plan : plans) {
    report.moved_m = std::max(report.moved_m, most_moved(walk, plan));
  }
  const std::vector<double> low = pelvis_lowering(walk, plans);
  report.lowered_m = *std::max_element(low.begin(), low.end());
  move_body(low, plans, walk);
  store(walk, cycle);
  return report;
}

}  // namespace promenade::motion
