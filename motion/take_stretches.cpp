#include "motion/take_stretches.h"

#include <algorithm>
#include <cmath>

namespace promenade::motion {
namespace {

using Body = Eigen::Matrix<double, 3, body_joint_count>;

constexpr double most_turn_rad = 0.5;       // in a second
constexpr double least_speed = 0.2;         // legs in a second
constexpr double least_seconds = 0.3;       // of a stretch
constexpr double least_leap_m = 0.1;        // of a joint, from one frame to the next
constexpr double leap_over_neighbours = 4;  // so much more than in the frames beside it

template <typename Test>
std::vector<FrameRange> runs(int frames, int least, const Test& test) {
  std::vector<FrameRange> found;
  for (int f = 0; f < frames; ++f) {
    if (!test(f)) continue;
    FrameRange run{f, f};
    while (f + 1 < frames && test(f + 1)) run.last = ++f;
    if (run.last - run.first + 1 >= least) found.push_back(run);
  }
  return found;
}

// Frames of half a second, at least one.
int half_second(const Take& take) {
  return std::max(1, static_cast<int>(std::lround(0.5 / take.frame_time)));
}

// 2 x T: the sum of all columns before each, so that means cost nothing; one column more.
Eigen::Matrix2Xd sums_of(const Eigen::Matrix2Xd& values) {
  Eigen::Matrix2Xd sums = Eigen::Matrix2Xd::Zero(2, values.cols() + 1);
  for (Eigen::Index f = 0; f < values.cols(); ++f) sums.col(f + 1) = sums.col(f) + values.col(f);
  return sums;
}

// Where the hips face over ground in each frame (x, z), 2 x T.
Eigen::Matrix2Xd facing(const Take& take, const std::vector<Body>& body) {
  Eigen::Matrix2Xd ahead(2, take.frames());
  for (int f = 0; f < take.frames(); ++f) {
    const Body& now = body[static_cast<std::size_t>(f)];
    const Eigen::Vector3d left = now.col(left_hip) - now.col(right_hip);
    ahead.col(f) = Eigen::Vector2d(-left.z(), left.x()).normalized();
  }
  return ahead;
}

// How far it turns in the second around a frame, radians: the hips sway with the steps, so the
// mean of half a second before is held against that of half a second after.
double turn_around(const Eigen::Matrix2Xd& sums, int frame, int half) {
  const auto frames = static_cast<int>(sums.cols()) - 1;
  const int from = std::max(frame - half, 0), to = std::min(frame + half, frames);
  const Eigen::Vector2d before = sums.col(frame) - sums.col(from);
  const Eigen::Vector2d after = sums.col(to) - sums.col(frame);
  // Two halves of half a second each lie half a second apart.
  return 2 *
         std::abs(std::atan2(before.x() * after.y() - before.y() * after.x(), before.dot(after)));
}

// m/s, over half a second around a frame.
double speed_around(const Take& take, int frame, int half) {
  const int from = std::max(frame - half / 2, 0);
  const int to = std::min(frame + (half + 1) / 2, take.frames() - 1);
  const Eigen::Vector3d way = take.poses[static_cast<std::size_t>(to)].root -
                              take.poses[static_cast<std::size_t>(from)].root;
  return std::hypot(way.x(), way.z()) / (std::max(to - from, 1) * take.frame_time);
}

// The furthest that a joint gets from each frame to the next, metres.
std::vector<double> steps_of(const std::vector<Body>& body) {
  std::vector<double> steps;
  for (std::size_t f = 0; f + 1 < body.size(); ++f) {
    steps.push_back((body[f + 1] - body[f]).colwise().norm().maxCoeff());
  }
  return steps;
}

std::vector<FrameRange> jumps_in(const std::vector<double>& steps) {
  std::vector<FrameRange> jumps;
  for (std::size_t f = 0; f < steps.size(); ++f) {
    // At an end of the take there is a neighbour on one side only.
    const double before = f > 0 ? steps[f - 1] : INFINITY;
    const double after = f + 1 < steps.size() ? steps[f + 1] : INFINITY;
    const double usual = std::min(before, after) + 0.01;
    const auto frame = static_cast<int>(f);
    if (steps[f] < least_leap_m || steps[f] < leap_over_neighbours * usual) continue;
    // There and back within two frames is one jump.
    if (!jumps.empty() && frame - jumps.back().last <= 1) {
      jumps.back().last = frame + 1;
    } else {
      jumps.push_back({frame, frame + 1});
    }
  }
  return jumps;
}

}  // namespace

TakeStretches find_stretches(const Take& take) {
  std::vector<Body> body;
  for (int f = 0; f < take.frames(); ++f) body.push_back(body_at(take, f));
  const int half = half_second(take);
  const int least = std::max(2, static_cast<int>(std::lround(least_seconds / take.frame_time)));
  const double slow = least_speed * leg_length(take.skeleton, take.body);
  const Eigen::Matrix2Xd sums = sums_of(facing(take, body));
  const auto stands = [&](int f) { return speed_around(take, f, half) < slow; };
  TakeStretches found;
  found.standing = runs(take.frames(), least, stands);
  found.turning = runs(take.frames(), least, [&](int f) {
    return !stands(f) && turn_around(sums, f, half) > most_turn_rad;
  });
  found.jumps = jumps_in(steps_of(body));
  return found;
}

std::vector<FrameRange> gaps_within(const Take& take, const std::vector<Gap>& gaps) {
  std::vector<FrameRange> found;
  for (const Gap& gap : gaps) {
    const int first = std::max(gap.frames.first - take.first_frame, 0);
    const int last = std::min(gap.frames.last - take.first_frame, take.frames() - 1);
    if (first <= last) found.push_back({first, last});
  }
  std::sort(found.begin(), found.end(),
            [](const FrameRange& a, const FrameRange& b) { return a.first < b.first; });
  std::vector<FrameRange> joined;
  for (const FrameRange& one : found) {
    if (!joined.empty() && one.first <= joined.back().last + 1) {
      joined.back().last = std::max(joined.back().last, one.last);
    } else {
      joined.push_back(one);
    }
  }
  return joined;
}

int frames_in(const std::vector<FrameRange>& stretches) {
  int frames = 0;
  for (const FrameRange& one : stretches) frames += one.last - one.first + 1;
  return frames;
}

}  // namespace promenade::motion
