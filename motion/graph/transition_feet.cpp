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

bool lands(const std::vector<StandingRun>& runs, int q) {
  return std::any_of(runs.begin(), runs.end(),
                     [q](const StandingRun& run) { return run.from <= q && q < run.still; });
}

}  // namespace

double standing_depth(const Blend& blend, std::size_t foot, int q,
                      std::vector<double> FootedLeg::*inside) {
  const auto& [i, j, k] = blend.frames;
  const double share = blend.share[static_cast<std::size_t>(q)];
  const double in_a = depth_at(blend.a.legs[foot].*inside, i - 1 + q);
  if (share == 0) return in_a;
  return (1 - share) * in_a + share * depth_at(blend.b.legs[foot].*inside, j - k + q);
}

std::vector<StandingRun> standing_runs(const Blend& blend, std::size_t foot) {
  std::vector<StandingRun> runs;
  for (int q = 0; q <= blend.last(); ++q) {
    if (standing_depth(blend, foot, q, &FootedLeg::standing) < 0) continue;
    if (runs.empty() || runs.back().to != q - 1) runs.push_back({q, q, q});
    StandingRun& run = runs.back();
    run.to = q;
    if (run.still == q && standing_depth(blend, foot, q, &FootedLeg::still) < 0) ++run.still;
  }
  return runs;
}

std::vector<Ground> foot_ground(const Blend& blend, std::size_t foot) {
  const LegJoints leg = leg_joints(foot_sides[foot]);
  const Heel heel = heel_of(blend, foot);
  std::vector<Ground> ground;
  for (int q = 0; q <= blend.last(); ++q) {
    ground.push_back(ground_under(heel, blend.place(q, leg.ankle), blend.place(q, leg.toe)));
  }
  return ground;
}

Eigen::Matrix2Xd support_steps(const Blend& blend, std::size_t foot,
                               const std::vector<StandingRun>& runs,
                               const std::vector<Ground>& ground) {
  const auto& [i, j, k] = blend.frames;
  const FootedLeg &a = blend.a.legs[foot], &b = blend.b.legs[foot];
  const Eigen::Rotation2Dd turn(-blend.move.theta);
  Eigen::Matrix2Xd steps(2, k);
  for (int q = 0; q < k; ++q) {
    const auto f = static_cast<std::size_t>(q);
    const int in_a = i - 1 + q, in_b = j - k + q;
    const double share = 0.5 * (blend.share[f] + blend.share[f + 1]);
    const Support point = share < 0.5 ? a.support[static_cast<std::size_t>(in_a)]
                                      : b.support[static_cast<std::size_t>(in_b)];
    steps.col(q) = (ground[f + 1] - ground[f]).col(static_cast<Eigen::Index>(point));
    if (!lands(runs, q)) continue;
    steps.col(q) -= (1 - share) * a.steps.col(in_a);
    if (in_b >= 0) steps.col(q) -= share * (turn * b.steps.col(in_b));
  }
  return steps;
}

double slide_m(const std::vector<StandingRun>& runs, const std::vector<Ground>& ground) {
  double longest = 0;
  for (const StandingRun& run : runs) {
    double way = 0;
    for (int q = run.still; q < run.to; ++q) {
      const auto f = static_cast<std::size_t>(q);
      way += (ground[f + 1] - ground[f]).colwise().norm().minCoeff();
    }
    longest = std::max(longest, way);
  }
  return longest;
}

}  // namespace promenade::motion
