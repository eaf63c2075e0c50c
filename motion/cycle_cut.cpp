#include "motion/cycle_cut.h"

#include <algorithm>
#include <cmath>

#include "motion/canonical.h"
#include "motion/rotation.h"

namespace promenade::motion {
namespace {

using Eigen::Quaterniond;
using Eigen::Vector3d;

constexpr int grid = 240;             // steps in a loop while it is worked on
constexpr double ease_seconds = 0.2;  // over which a jump in velocity is taken up

// Poses at equal steps of one cycle, the closing one included.
struct Loop {
  double seconds = 0;
  std::vector<Pose> poses;  // grid + 1
};

Loop sample(const Take& take, const CycleCandidate& cut) {
  Loop loop;
  loop.seconds = cut.length() * take.frame_time;
  for (int k = 0; k <= grid; ++k) {
    loop.poses.push_back(pose_at(take, cut.first() + cut.length() * k / grid));
    if (k == 0) continue;
    const Pose& before = loop.poses[static_cast<std::size_t>(k - 1)];
    Pose& now = loop.poses.back();
    for (std::size_t j = 0; j < now.rotations.size(); ++j) {
      if (now.rotations[j].dot(before.rotations[j]) < 0) now.rotations[j].coeffs() *= -1;
    }
  }
  return loop;
}

Quaterniond about_y(double angle) {
  return Quaterniond(Eigen::AngleAxisd(angle, Vector3d::UnitY()));
}

// Takes out a turn that goes on evenly over the loop: the path becomes straight.
void straighten(Loop& loop, double turn) {
  Vector3d raw = loop.poses.front().root;
  for (int k = 1; k <= grid; ++k) {
    Pose& pose = loop.poses[static_cast<std::size_t>(k)];
    const Vector3d& reached = loop.poses[static_cast<std::size_t>(k - 1)].root;
    const Vector3d step = pose.root - raw;
    raw = pose.root;
    pose.root = reached + about_y(-turn * (k - 0.5) / grid) * step;
    pose.rotations[0] = about_y(-turn * k / grid) * pose.rotations[0];
  }
}

// Where the figure faces on the mean, over ground: square to its hips.
Vector3d facing(const Take& take, const CycleCandidate& cut) {
  Vector3d sum = Vector3d::Zero();
  for (int k = 0; k < 8; ++k) {
    const auto body = body_at(take, cut.first() + cut.length() * k / 8);
    sum += (body.col(left_hip) - body.col(right_hip)).cross(Vector3d::UnitY());
  }
  return sum;
}

// Turns all of it so that it walks along +Z; one that stays in its place faces there.
void align(const Take& take, const CycleCandidate& cut, Loop& loop) {
  Vector3d travel = loop.poses.back().root - loop.poses.front().root;
  const double way = std::hypot(travel.x(), travel.z());
  if (way < 0.25 * leg_length(take.skeleton, take.body)) travel = facing(take, cut);
  const Quaterniond turn = about_y(-std::atan2(travel.x(), travel.z()));
  for (Pose& pose : loop.poses) {
    pose.root = turn * pose.root;
    pose.rotations[0] = turn * pose.rotations[0];
  }
}

// What to add at a time so that a gap in value (end minus start) closes over the
// loop, and a gap in velocity beside the seam. Half of each at either end; the sum
// has no velocity of its own at the seam but the one that is wanted.
struct Closing {
  double seconds = 1;

  double value(double t) const {
    const double x = t / seconds;
    return 0.5 - x * x * (3 - 2 * x);
  }
  double velocity(double t) const {
    const double reach = std::min(ease_seconds, 0.45 * seconds);
    const double from_seam = std::min(t, seconds - t);
    const double rest = std::max(1 - from_seam / reach, 0.0);
    return 0.5 * from_seam * rest * rest;
  }
};

// Velocities at the first and last pose, from what lies beyond them in the take where
// it goes on, and one-sided where it ends.
struct Velocity {
  Vector3d root;
  std::vector<Vector3d> rotations;  // rad/s, each in the joint's own frame
};

Velocity velocity_at(const Take& take, double frame, const Quaterniond& turn) {
  const double before = std::max(frame - 0.5, 0.0);
  const double after = std::min(frame + 0.5, take.frames() - 1.0);
  const Pose a = pose_at(take, before), b = pose_at(take, after);
  const double seconds = (after - before) * take.frame_time;
  Velocity velocity{turn * (b.root - a.root) / seconds, {}};
  for (std::size_t j = 0; j < a.rotations.size(); ++j) {
    velocity.rotations.emplace_back(log_of(a.rotations[j].conjugate() * b.rotations[j]) / seconds);
  }
  return velocity;
}

// How the loop's frame is turned against the take's at its first and last pose.
Quaterniond turn_between(const Take& take, double frame, const Pose& pose) {
  return pose.rotations[0] * pose_at(take, frame).rotations[0].conjugate();
}

void close_loop(const Take& take, const CycleCandidate& cut, Loop& loop) {
  const Pose first = loop.poses.front(), last = loop.poses.back();
  const Velocity start = velocity_at(take, cut.first(), turn_between(take, cut.first(), first));
  const Velocity end =
      velocity_at(take, cut.keys.back(), turn_between(take, cut.keys.back(), last));
  const Closing closing{loop.seconds};
  for (int k = 0; k <= grid; ++k) {
    Pose& pose = loop.poses[static_cast<std::size_t>(k)];
    const double t = loop.seconds * k / grid;
    const double a = closing.value(t), b = closing.velocity(t);
    const Vector3d bend = b * (end.root - start.root);
    pose.root += Vector3d(bend.x(), bend.y() + a * (last.root.y() - first.root.y()), bend.z());
    for (std::size_t j = 0; j < pose.rotations.size(); ++j) {
      const Vector3d gap = log_of(first.rotations[j].conjugate() * last.rotations[j]);
      const Vector3d change = end.rotations[j] - start.rotations[j];
      pose.rotations[j] = pose.rotations[j] * exp_of(a * gap + b * change);
    }
  }
}

Pose pose_of(const Loop& loop, double seconds) {
  const double position = std::clamp(grid * seconds / loop.seconds, 0.0, double{grid});
  const auto k = static_cast<std::size_t>(std::min(std::floor(position), grid - 1.0));
  return mix(loop.poses[k], loop.poses[k + 1], position - static_cast<double>(k));
}

std::vector<double> keytimes_of(const CycleCandidate& cut, double frame_time) {
  std::vector<double> keytimes;
  for (const double key : cut.keys) keytimes.push_back((key - cut.first()) * frame_time);
  return keytimes;
}

}  // namespace

Cycle cut_cycle(const MotionSet& set, const Take& take, const CycleCandidate& candidate) {
  Loop loop = sample(take, candidate);
  straighten(loop, candidate.turn);
  align(take, candidate, loop);
  close_loop(take, candidate, loop);
  const double scale = leg_length(set.skeleton, set.body) / leg_length(take.skeleton, take.body);
  for (Pose& pose : loop.poses) pose.root *= scale;
  const auto pose = [&loop](double seconds) { return pose_of(loop, seconds); };
  Cycle cycle = canonical_cycle(set, keytimes_of(candidate, take.frame_time), pose);
  cycle.source = take.source;
  cycle.first_frame = take.first_frame + static_cast<int>(std::lround(candidate.first()));
  cycle.frames = static_cast<int>(std::lround(candidate.length()));
  cycle.loop_error_m = candidate.loop_error_m;
  cycle.origin.frame_time = take.frame_time;
  cycle.origin.turn = candidate.turn;
  cycle.origin.straightness = candidate.straightness;
  cycle.origin.scale = scale;
  return cycle;
}

}  // namespace promenade::motion
