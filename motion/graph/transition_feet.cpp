#include "motion/graph/transition_feet.h"

#include <algorithm>

namespace promenade::motion {
namespace {

double depth_at(const std::vector<double>& standing, int frame) {
  return standing[static_cast<std::size_t>(frame)];
}

// The mean of the two captures' heels: they are one person's, or two of like size.
Heel heel_of(const Blend& blend, std::size_t foot) {
  const Heel &a = blend.a.legs[foot].heel, &b = blend.b.legs[foot].heel;
  return {0.5 * (a.behind + b.behind), 0.5 * (a.below + b.below)};
}

}  // namespace

std::vector<StandingRun> standing_runs(const Blend& blend, std::size_t foot) {
  const std::vector<double>& in_a = blend.a.legs[foot].standing;
  const std::vector<double>& in_b = blend.b.legs[foot].standing;
  const TransitionFrames& frames = blend.frames;
  std::vector<StandingRun> runs;
  for (int q = 0; q <= frames.k; ++q) {
    const double share = blend.share[static_cast<std::size_t>(q)];
    double depth = (1 - share) * depth_at(in_a, frames.i - 1 + q);
    if (q > 0) depth += share * depth_at(in_b, frames.j - frames.k + q);
    if (depth < 0) continue;
    if (!runs.empty() && runs.back().to == q - 1) {
      runs.back().to = q;
    } else {
      runs.push_back({q, q});
    }
  }
  return runs;
}

FootPlaces foot_places(const Blend& blend, std::size_t foot) {
  const LegJoints leg = leg_joints(foot_sides[foot]);
  FootPlaces places;
  places.ankle.resize(3, blend.last() + 1);
  places.toe.resize(3, blend.last() + 1);
  for (int q = 0; q <= blend.last(); ++q) {
    places.ankle.col(q) = blend.place(q, leg.ankle);
    places.toe.col(q) = blend.place(q, leg.toe);
  }
  return places;
}

FootPlaces foot_places(const Blend& blend, std::size_t foot, std::span<const WorldPose> worlds) {
  const LegJoints leg = leg_joints(foot_sides[foot]);
  FootPlaces places;
  places.ankle.resize(3, blend.last() + 1);
  places.toe.resize(3, blend.last() + 1);
  for (int q = 0; q <= blend.last(); ++q) {
    const Eigen::Matrix3Xd& world = worlds[static_cast<std::size_t>(q)].positions;
    places.ankle.col(q) = world.col(blend.body().joint[leg.ankle]);
    places.toe.col(q) = world.col(blend.body().joint[leg.toe]);
  }
  return places;
}

Eigen::Matrix2Xd support_steps(const Blend& blend, std::size_t foot, const FootPlaces& places) {
  const Heel heel = heel_of(blend, foot);
  const auto ground = [&](Eigen::Index q) {
    Eigen::Matrix3d points;
    points.col(0) = heel_position(heel, places.ankle.col(q), places.toe.col(q));
    points.col(1) = places.ankle.col(q);
    points.col(2) = places.toe.col(q);
    Eigen::Matrix<double, 2, 3> flat;
    flat << points.row(0), points.row(2);
    return flat;
  };
  Eigen::Matrix2Xd steps(2, blend.last());
  Eigen::Matrix<double, 2, 3> before = ground(0);
  for (Eigen::Index q = 0; q < steps.cols(); ++q) {
    const Eigen::Matrix<double, 2, 3> now = ground(q + 1);
    Eigen::Index least = 0;
    (now - before).colwise().squaredNorm().minCoeff(&least);
    steps.col(q) = now.col(least) - before.col(least);
    before = now;
  }
  return steps;
}

double slide_m(const std::vector<StandingRun>& runs, const Eigen::Matrix2Xd& steps) {
  double longest = 0;
  for (const StandingRun& run : runs) {
    longest =
        std::max(longest, steps.middleCols(run.from, run.to - run.from).colwise().norm().sum());
  }
  return longest;
}

}  // namespace promenade::motion
