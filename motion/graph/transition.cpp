#include "motion/graph/transition.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "motion/angles.h"
#include "motion/graph/transition_feet.h"

namespace promenade::motion {
namespace {

constexpr double around_s = 1;  // of the captures, on either side of their windows

std::string rounded(double value) { return std::to_string(static_cast<long>(std::ceil(value))); }

// The poses from two frames before the transition to one after B_j, as far as there are any,
// each as it is seen.
std::vector<WorldPose> worlds_of(const Blend& blend, int& before) {
  const auto& [i, j, k] = blend.frames;
  std::vector<WorldPose> worlds;
  before = 0;
  if (i >= 2) {
    worlds.push_back(
        forward_kinematics(blend.skeleton(), blend.a.take.poses[static_cast<std::size_t>(i - 2)]));
    before = 1;
  }
  for (const Pose& pose : blend.poses) {
    worlds.push_back(forward_kinematics(blend.skeleton(), pose));
  }
  if (j + 1 < blend.b.take.frames()) {
    worlds.push_back(forward_kinematics(
        blend.skeleton(), moved(blend.move, blend.b.take.poses[static_cast<std::size_t>(j + 1)])));
  }
  return worlds;
}

KneeAxes mean_axes(const FootedTake& a, const FootedTake& b) {
  return {(a.legs[0].knee + b.legs[0].knee).normalized(),
          (a.legs[1].knee + b.legs[1].knee).normalized()};
}

FrameGap gap_around(const FootedTake& footed, int from, int to) {
  const int around = static_cast<int>(std::lround(around_s / footed.take.frame_time));
  const int first = std::max(from - around, 0);
  const int last = std::min(to + around, footed.take.frames() - 1);
  return largest_gap(
      std::span(footed.gaps)
          .subspan(static_cast<std::size_t>(first), static_cast<std::size_t>(last - first + 1)));
}

void measure(const Blend& blend, const std::array<std::vector<StandingRun>, 2>& runs,
             Transition& transition) {
  TransitionQuality& quality = transition.quality;
  int before = 0;
  const std::vector<WorldPose> worlds = worlds_of(blend, before);
  const KneeAxes axes = mean_axes(blend.a, blend.b);
  for (std::size_t f = 1; f + 1 < worlds.size(); ++f) {
    const FrameGap gap =
        frame_gap(blend.skeleton(), blend.body(), axes, worlds[f - 1], worlds[f], worlds[f + 1]);
    quality.gap_m = std::max(quality.gap_m, gap.place_m);
    quality.knee_gap = std::max(quality.knee_gap, gap.knee);
  }
  const auto& [i, j, k] = blend.frames;
  const FrameGap in_a = gap_around(blend.a, i, i + k - 1);
  const FrameGap in_b = gap_around(blend.b, j - k + 1, j);
  quality.inside_gap_m = std::max(in_a.place_m, in_b.place_m);
  quality.inside_knee_gap = std::max(in_a.knee, in_b.knee);
  const auto seen = std::span(worlds).subspan(static_cast<std::size_t>(before));
  for (std::size_t foot = 0; foot < 2; ++foot) {
    const double slide =
        slide_m(runs[foot], support_steps(blend, foot, foot_places(blend, foot, seen)));
    quality.slide_m = std::max(quality.slide_m, slide);
  }
}

std::string refusal_of(const TransitionQuality& quality, const TransitionLimits& limits) {
  if (quality.slide_m > limits.most_slide_m) {
    return "a foot would slide " + rounded(1000 * quality.slide_m) + " mm";
  }
  if (quality.gap_m > quality.inside_gap_m) {
    return "a joint would jump by " + rounded(1000 * quality.gap_m) + " mm from frame to frame";
  }
  if (quality.knee_gap > quality.inside_knee_gap) {
    return "a knee would snap by " + rounded(quality.knee_gap / degree) + " degrees";
  }
  return {};
}

}  // namespace

double weight_of_first(int p, int k) {
  const double x = std::clamp((p + 1) / static_cast<double>(k), 0.0, 1.0);
  return x * x * (2 * x - 3) + 1;
}

Transition make_transition(const FootedTake& a, const FootedTake& b, const TransitionFrames& frames,
                           const PlanarMove& match, const TransitionLimits& limits) {
  const auto& [i, j, k] = frames;
  assert(k >= 2 && i >= 0 && i + k <= a.take.frames() && "a window of the take that is left");
  assert(j - k + 1 >= 0 && j < b.take.frames() && "a window of the take that is entered");
  Transition transition;
  transition.move = match;
  if (i == 0) {
    transition.refusal = "no frame stands before it";
    return transition;
  }
  const Blend blend = make_blend(a, b, frames, match);
  const std::array runs = {standing_runs(blend, 0), standing_runs(blend, 1)};
  measure(blend, runs, transition);
  transition.quality.slide_raw_m = transition.quality.slide_m;
  transition.refusal = refusal_of(transition.quality, limits);
  transition.poses.assign(blend.poses.begin() + 1, blend.poses.end() - 1);
  return transition;
}

}  // namespace promenade::motion
