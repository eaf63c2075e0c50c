#include "motion/foot_plant.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "motion/rotation.h"

namespace promenade::motion {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr double fade_seconds = 0.1;  // over which a swinging foot forgets its velocity
// A leg reaches at most this share of its length: a knee that comes out of a straight
// leg would snap.
constexpr double most_reach = 0.9965;
constexpr double most_speed_change = 0.04;  // of the walk's speed

// Phases of a stance, the second beyond F where it runs over the seam.
struct StancePhases {
  int on = 0, off = 0;
};

StancePhases stance_phases(const MotionSet& set, Side side) {
  const auto at = [&](std::size_t key) {
    return static_cast<int>(std::lround(set.key_phases[key] * set.phases));
  };
  if (side == Side::right) return {at(1), at(4)};
  return {at(3), at(2) + set.phases};
}

// A cycle while its feet are planted: the poses of its phases, and what they look like.
struct Walk {
  const MotionSet& set;
  const Cycle& cycle;
  std::vector<Pose> poses;        // F
  std::vector<WorldPose> worlds;  // F, before anything is moved
  std::vector<double> times;      // F + 1, seconds

  int phases() const { return set.phases; }
  std::size_t wrapped(int f) const { return static_cast<std::size_t>(f % phases()); }
  double time(int f) const { return times[wrapped(f)] + f / phases() * cycle.seconds; }

  // Over the ground: left and ahead, metres.
  Vector2d ground(int f, BodyJoint part) const {
    const Vector3d at = worlds[wrapped(f)].positions.col(set.body.joint[part]);
    return Vector2d(at.x(), at.z()) + time(f) * cycle.velocity;
  }
};

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

Vector3d at(const Walk& walk, std::size_t f, BodyJoint part) {
  return walk.worlds[f].positions.col(walk.set.body.joint[part]);
}

// The phase at which the foot changes from standing by its ankle to standing by its
// toe: where both together have moved least.
int heel_off(const Walk& walk, const StancePhases& stance, const LegJoints& leg) {
  const auto step = [&](int f, BodyJoint part) {
    return (walk.ground(f + 1, part) - walk.ground(f, part)).norm();
  };
  double moved = 0;
  for (int f = stance.on; f < stance.off; ++f) moved += step(f, leg.toe);
  double least = moved;
  int best = stance.on;
  for (int f = stance.on; f < stance.off; ++f) {
    moved += step(f, leg.ankle) - step(f, leg.toe);
    if (moved < least) {
      least = moved;
      best = f + 1;
    }
  }
  return best;
}

// 2 x (phases of the stance): how far the ankle must be moved so that the foot stands,
// with mean 0 over the stance.
Eigen::Matrix2Xd stance_shift(const Walk& walk, const StancePhases& stance, const LegJoints& leg) {
  const int change = heel_off(walk, stance, leg);
  Eigen::Matrix2Xd shift(2, stance.off - stance.on + 1);
  shift.col(0).setZero();
  for (int f = stance.on; f < stance.off; ++f) {
    const BodyJoint held = f < change ? leg.ankle : leg.toe;
    shift.col(f + 1 - stance.on) =
        shift.col(f - stance.on) - (walk.ground(f + 1, held) - walk.ground(f, held));
  }
  const Vector2d mean = shift.rowwise().mean();
  shift.colwise() -= mean;
  return shift;
}

// What is changed of a foot: rows 0 and 1 move it over the ground (left, ahead; metres),
// rows 2 to 4 turn it about its toe (a rotation vector in the world, radians).
using FootChange = Eigen::Matrix<double, 5, 1>;
using FootChanges = Eigen::Matrix<double, 5, Eigen::Dynamic>;

// A foot whose toe is held back while the ankle goes on comes up a little more: it turns
// about the toe towards where its ankle was, the more the nearer it is to leaving.
FootChanges stance_changes(const Walk& walk, const StancePhases& stance, const LegJoints& leg) {
  const Eigen::Matrix2Xd shift = stance_shift(walk, stance, leg);
  FootChanges changes = FootChanges::Zero(5, shift.cols());
  changes.topRows<2>() = shift;
  const double middle = 0.5 * (walk.time(stance.on) + walk.time(stance.off));
  const double start = std::max(middle, walk.time(heel_off(walk, stance, leg)));
  for (int f = stance.on; f <= stance.off; ++f) {
    const double x = (walk.time(f) - start) / std::max(walk.time(stance.off) - start, 1e-9);
    if (x <= 0) continue;
    const Vector3d foot = at(walk, walk.wrapped(f), leg.ankle) - at(walk, walk.wrapped(f), leg.toe);
    const Vector2d moved = shift.col(f - stance.on);
    const Eigen::Quaterniond turn =
        Eigen::Quaterniond::FromTwoVectors(foot, foot - Vector3d(moved.x(), 0, moved.y()));
    changes.col(f - stance.on).tail<3>() = x * x * (3 - 2 * x) * log_of(turn);
  }
  return changes;
}

// From one stance to the next: the change goes over smoothly, and its velocity at either
// end dies away.
struct Fade {
  double seconds;
  FootChange from, to, leaving, arriving;  // the last two per second

  FootChange at(double t) const {
    const double x = t / seconds;
    const double eased = x * x * (3 - 2 * x);
    const double reach = std::min(fade_seconds, 0.5 * seconds);
    const auto ramp = [reach](double u) {
      const double rest = std::max(1 - u / reach, 0.0);
      return u * rest * rest;
    };
    return (1 - eased) * from + eased * to + ramp(t) * leaving - ramp(seconds - t) * arriving;
  }
};

// 5 x F: the change of one foot over the whole cycle.
FootChanges foot_changes(const Walk& walk, Side side) {
  const StancePhases stance = stance_phases(walk.set, side);
  const FootChanges stood = stance_changes(walk, stance, leg_joints(side));
  const Eigen::Index last = stood.cols() - 1;
  const int next_on = stance.on + walk.phases();
  Fade fade;
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

FootTarget target_of(const Walk& walk, std::size_t f, Side side, const FootChange& change) {
  const LegJoints leg = leg_joints(side);
  const Vector3d toe = at(walk, f, leg.toe);
  const Eigen::Quaterniond turn = exp_of(change.tail<3>());
  const auto foot = static_cast<std::size_t>(walk.set.body.joint[leg.ankle]);
  return {toe + Vector3d(change(0), 0, change(1)) + turn * (at(walk, f, leg.ankle) - toe),
          turn * walk.worlds[f].rotations[foot]};
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
    const Eigen::Matrix2Xd shift = stance_shift(walk, stance, leg_joints(side));
    drift += shift(1, 0) - shift(1, shift.cols() - 1);
    seconds += walk.time(stance.off) - walk.time(stance.on);
  }
  const double most = most_speed_change * walk.cycle.velocity.norm();
  return walk.cycle.velocity + Vector2d(0, std::clamp(-drift / seconds, -most, most));
}

// Never less than the values, and smooth around the cycle.
std::vector<double> smooth_cover(const std::vector<double>& values) {
  const int size = static_cast<int>(values.size());
  const int reach = std::max(size / 15, 1);
  const auto around = [&](const std::vector<double>& v, int f) {
    return v[static_cast<std::size_t>((f + size) % size)];
  };
  std::vector<double> covered(values.size()), smooth(values.size(), 0);
  for (int f = 0; f < size; ++f) {
    double& most = covered[static_cast<std::size_t>(f)];
    for (int d = -reach; d <= reach; ++d) most = std::max(most, around(values, f + d));
  }
  double total = 0;
  for (int d = -reach; d <= reach; ++d) {
    const double weight = 0.5 + 0.5 * std::cos(M_PI * d / (reach + 1));
    total += weight;
    for (int f = 0; f < size; ++f) {
      smooth[static_cast<std::size_t>(f)] += weight * around(covered, f + d);
    }
  }
  for (double& value : smooth) value /= total;
  return smooth;
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
  assert(set.key_phases.size() == 5 && "a walk has five keytimes");
  Walk walk = make_walk(set, cycle);
  PlantReport report;
  report.speed_change = -cycle.velocity.norm();
  cycle.velocity = speed_of_feet(walk);
  report.speed_change += cycle.velocity.norm();
  std::vector<std::array<FootTarget, 2>> targets(walk.poses.size());
  std::vector<double> low(walk.poses.size(), 0);
  std::array<Vector3d, 2> axes;
  for (const Side side : {Side::left, Side::right}) {
    const auto s = static_cast<std::size_t>(side);
    const FootChanges changes = foot_changes(walk, side);
    axes[s] = knee_axis(set.skeleton, set.body, side, walk.poses);
    for (std::size_t f = 0; f < low.size(); ++f) {
      const LegJoints leg = leg_joints(side);
      targets[f][s] = target_of(walk, f, side, changes.col(static_cast<Eigen::Index>(f)));
      low[f] = std::max(low[f], lowering(walk, f, leg, targets[f][s].ankle));
      const double moved = (targets[f][s].ankle - at(walk, f, leg.ankle)).norm();
      report.moved_m = std::max(report.moved_m, moved);
    }
  }
  low = smooth_cover(low);
  for (std::size_t f = 0; f < low.size(); ++f) {
    report.lowered_m = std::max(report.lowered_m, low[f]);
    walk.poses[f].root.y() -= low[f];
    for (const Side side : {Side::left, Side::right}) {
      const auto s = static_cast<std::size_t>(side);
      move_foot(set.skeleton, set.body, side, axes[s], targets[f][s], walk.poses[f]);
    }
  }
  store(walk, cycle);
  return report;
}

}  // namespace promenade::motion
