#include "motion/graph/transition.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <iterator>

#include "motion/angles.h"
#include "motion/graph/transition_lay.h"
#include "motion/graph/transition_plant.h"

namespace promenade::motion {
namespace {

constexpr double around_seconds = 1;      // of the captures, on either side of their windows
constexpr double least_slide_m = 0.0005;  // feet that slide less are left as they are
// What nobody sees, where captures hardly move: they would refuse every change.
constexpr double least_gap_m = 0.0005;
constexpr double least_knee_gap = 0.1 * degree;
constexpr double rounding = 1 + 1e-9;  // of a gap that is the captures' own

std::string rounded_up(double value) { return std::to_string(std::lround(std::ceil(value))); }

// What is seen from two frames before the transition to two after it, as far as there is any.
std::vector<WorldPose> worlds_around(const Blend& blend) {
  const auto& [i, j, k] = blend.frames;
  const auto seen = [&](const Pose& pose) { return forward_kinematics(blend.skeleton(), pose); };
  std::vector<WorldPose> worlds;
  worlds.reserve(blend.poses.size() + 2);
  if (i >= 2) worlds.push_back(seen(blend.a.take.poses[static_cast<std::size_t>(i - 2)]));
  for (std::size_t q = 0; q < blend.poses.size(); ++q) {
    worlds.push_back(placed(blend.poses[q], blend.figures[q]));
  }
  if (j + 1 < blend.b.take.frames()) {
    worlds.push_back(seen(moved(blend.move, blend.b.take.poses[static_cast<std::size_t>(j + 1)])));
  }
  return worlds;
}

FrameGap gap_of(const Blend& blend) {
  const std::vector<WorldPose> worlds = worlds_around(blend);
  std::vector<FrameGap> gaps;
  gaps.reserve(worlds.size());
  for (std::size_t f = 1; f + 1 < worlds.size(); ++f) {
    gaps.push_back(frame_gap(blend.skeleton(), blend.body(), blend.knees, worlds[f - 1], worlds[f],
                             worlds[f + 1]));
  }
  return largest_gap(gaps);
}

// Of a capture by itself, around its window.
FrameGap gap_inside(const FootedTake& footed, int from, int to) {
  const int around = static_cast<int>(std::lround(around_seconds / footed.take.frame_time));
  const int first = std::max(from - around, 0);
  const int last = std::min(to + around, footed.take.frames() - 1);
  return largest_gap(
      std::span(footed.gaps)
          .subspan(static_cast<std::size_t>(first), static_cast<std::size_t>(last - first + 1)));
}

void measure_gaps(const Blend& blend, TransitionQuality& quality) {
  const auto& [i, j, k] = blend.frames;
  const FrameGap gap = gap_of(blend);
  const FrameGap inside =
      largest_gap(std::array{gap_inside(blend.a, i, i + k - 1), gap_inside(blend.b, j - k + 1, j)});
  quality.gap_m = gap.place_m;
  quality.knee_gap = gap.knee;
  quality.inside_gap_m = inside.place_m;
  quality.inside_knee_gap = inside.knee;
}

std::array<double, 2> slides(const Blend& blend, const FootRuns& runs) {
  return {slide_m(runs[0], foot_ground(blend, 0)), slide_m(runs[1], foot_ground(blend, 1))};
}

std::string refusal_of(const std::array<double, 2>& slide, const TransitionQuality& quality,
                       const TransitionLimits& limits) {
  if (quality.slide_m > limits.most_slide_m) {
    return std::string(slide[0] > slide[1] ? "the left" : "the right") + " foot would slide " +
           rounded_up(1000 * quality.slide_m) + " mm";
  }
  if (quality.gap_m > std::max(rounding * quality.inside_gap_m, least_gap_m)) {
    return "a joint would jump by " + rounded_up(1000 * quality.gap_m) +
           " mm between frames, more than in the captures";
  }
  if (quality.knee_gap > std::max(rounding * quality.inside_knee_gap, least_knee_gap)) {
    return "a knee would snap by " + rounded_up(quality.knee_gap / degree) +
           " degrees between frames, more than in the captures";
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
  Blend blend = make_blend(a, b, frames, match);
  const FootRuns runs = {standing_runs(blend, 0), standing_runs(blend, 1)};
  TransitionQuality& quality = transition.quality;
  std::array slide = slides(blend, runs);
  quality.slide_raw_m = std::max(slide[0], slide[1]);
  if (quality.slide_raw_m > least_slide_m) {
    lay_by_feet(blend, runs);
    quality.moved_m = plant_feet(blend, runs);
    slide = slides(blend, runs);
  }
  quality.slide_m = std::max(slide[0], slide[1]);
  measure_gaps(blend, quality);
  transition.move = blend.move;
  transition.refusal = refusal_of(slide, quality, limits);
  transition.poses.assign(std::make_move_iterator(blend.poses.begin() + 1),
                          std::make_move_iterator(blend.poses.end() - 1));
  return transition;
}

}  // namespace promenade::motion
