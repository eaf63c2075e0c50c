#include "motion/foot_plant.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "motion/heel.h"
#include "motion/rotation.h"

namespace promenade::motion {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr double fade_seconds = 0.1;   // over which a swinging foot forgets its velocity
constexpr double cover_seconds = 0.1;  // over which the pelvis comes down and up again
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
  double time(int f) const {
    const int turns = f / phases();
    return times[wrapped(f)] + turns * cycle.seconds;
  }

  Vector3d place(int f, BodyJoint part) const {
    return worlds[wrapped(f)].positions.col(set.body.joint[part]);
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
  return walk.place(static_cast<int>(f), part);
}

// One step of a stance, from phase to phase over the ground: left and ahead, metres.
struct FootStep {
  Vector2d sole, toe;  // sole: the one of heel and ankle that moves less
};

// A foot that strikes with its heel turns about it until it is flat. Then heel and ankle
// stand both, and at last the toe alone.
std::vector<FootStep> foot_steps(const Walk& walk, const StancePhases& stance,
                                 const LegJoints& leg) {
  const int flat = (stance.on + stance.off) / 2;
  const Heel heel = find_heel(walk.place(flat, leg.ankle), walk.place(flat, leg.toe));
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

// The step from which on a foot stands by its toe: where all together move least.
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

// 2 x (phases of the stance): how far the ankle must be moved so that the foot stands,
// with mean 0 over the stance.
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
    const Eigen::Matrix2Xd shift = stance_shift(foot_steps(walk, stance, leg_joints(side)));
    drift += shift(1, 0) - shift(1, shift.cols() - 1);
    seconds += walk.time(stance.off) - walk.time(stance.on);
  }
  const double most = most_speed_change * walk.cycle.velocity.norm();
  return walk.cycle.velocity + Vector2d(0, std::clamp(-drift / seconds, -most, most));
}

// Never less than the values (F), and smooth in time around the cycle. Phases lie close
// together where both feet stand, so it is time that counts.
std::vector<double> smooth_cover(const Walk& walk, const std::vector<double>& values) {
  const int size = walk.phases();
  const auto weight = [&](int f, int g) {
    double apart = std::abs(walk.times[walk.wrapped(f)] - walk.times[walk.wrapped(g)]);
    apart = std::min(apart, walk.cycle.seconds - apart);
    return apart < cover_seconds ? 0.5 + 0.5 * std::cos(M_PI * apart / cover_seconds) : 0;
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

// Where one foot is wanted at every phase, and about what its knee bends.
struct FootPlan {
  Side side;
  Vector3d knee;
  std::vector<FootTarget> targets;  // F
};

FootPlan plan_foot(const Walk& walk, Side side) {
  FootPlan plan{side, knee_axis(walk.set.skeleton, walk.set.body, side, walk.poses), {}};
  const FootChanges changes = foot_changes(walk, side);
  for (std::size_t f = 0; f < walk.poses.size(); ++f) {
    plan.targets.push_back(target_of(walk, f, side, changes.col(static_cast<Eigen::Index>(f))));
  }
  return plan;
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
  assert(set.key_phases.size() == 5 && "a walk has five keytimes");
  Walk walk = make_walk(set, cycle);
  PlantReport report;
  report.speed_change = -cycle.velocity.norm();
  cycle.velocity = speed_of_feet(walk);
  report.speed_change += cycle.velocity.norm();
  const std::array<FootPlan, 2> plans = {plan_foot(walk, Side::left), plan_foot(walk, Side::right)};
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
