#include "study/target_draw.h"

#include <algorithm>
#include <cmath>

#include "motion/quantile.h"
#include "study/reach_models.h"

namespace promenade::study {
namespace {

using Eigen::VectorXd;
using motion::DistancePoints;

constexpr int mixed_walks = 3;
// A source passes the check of a study when one in twenty walks is far enough.
constexpr int most_tries = 2000;

VectorXd equal_weights(int n) { return VectorXd::Constant(n, 1.0 / n); }

// Uniform over the box of the parameters.
DrawWalk uniform_setting(const motion::ControlMap& map) {
  return [problem = map.problem](Rng& rng) {
    VectorXd at = problem.box.low;
    for (Eigen::Index i = 0; i < at.size(); ++i) {
      at(i) += rng.uniform() * (problem.box.high(i) - problem.box.low(i));
    }
    VectorXd weights = problem.start;
    problem.weights(at, weights);
    return weights;
  };
}

// Exponential shares, normalised: uniform over the simplex.
DrawWalk mixture_of_walks(int n) {
  return [n](Rng& rng) {
    std::vector<int> walks;
    for (int i = 0; i < n; ++i) walks.push_back(i);
    rng.shuffle(walks);
    VectorXd weights = VectorXd::Zero(n);
    for (int i = 0; i < std::min(n, mixed_walks); ++i) {
      weights(walks[static_cast<std::size_t>(i)]) = -std::log(1 - rng.uniform());
    }
    return VectorXd(weights / weights.sum());
  };
}

DrawWalk one_walk(int n) {
  return [n](Rng& rng) {
    return VectorXd(VectorXd::Unit(n, static_cast<int>(rng.below(static_cast<std::uint64_t>(n)))));
  };
}

WalkSource place_on_map(const motion::MotionSpace& space) {
  const motion::Pca pca = motion::principal_components(space);
  if (pca.components() == 0) return {{}, "all cycles of the set are alike"};
  const auto map = std::make_shared<const motion::Minimap>(
      motion::make_minimap(pca, {.heuristic = motion::MapHeuristic::random}));
  const Eigen::Vector2d deviations = motion::valid_radii(*map) / map->point_limit;
  const auto draw = [map, deviations](Rng& rng) {
    const double x = rng.normal();
    const Eigen::Vector2d point = deviations.cwiseProduct(Eigen::Vector2d(x, rng.normal()));
    const motion::MapState state = motion::move(*map, motion::start_map(*map), {point, true, 0},
                                                [&rng] { return rng.normal(); });
    VectorXd weights;
    motion::weights_at(*map, state, 0, weights);
    return weights;
  };
  return {draw, ""};
}

WalkSource sliders(const ControlMapOrReason& found) {
  if (!found.map) return {{}, found.reason};
  return {uniform_setting(*found.map), ""};
}

double start_of(const motion::PoseBank& bank, const VectorXd& weights, DistanceTimes times) {
  return motion::distance(blend_points(bank, weights, times),
                          blend_points(bank, equal_weights(bank.size()), times))
      .mean_m;
}

// Always the same ones, of a stream of their own.
std::vector<double> tried(const motion::PoseBank& bank, const DrawWalk& draw, DistanceTimes times) {
  Rng rng(1, 0, "starts");
  std::vector<double> starts;
  for (int i = 0; i < tried_starts; ++i) starts.push_back(start_of(bank, draw(rng), times));
  return starts;
}

VectorXd draw_far(const motion::PoseBank& bank, const DrawWalk& draw, const DrawRules& rules,
                  const std::vector<VectorXd>& before, Rng& rng) {
  VectorXd weights = draw(rng);
  for (int i = 1; i < most_tries; ++i) {
    const bool is_new = std::find(before.begin(), before.end(), weights) == before.end();
    if (is_new && start_of(bank, weights, rules.times) >= rules.least_start_m) break;
    weights = draw(rng);
  }
  return weights;
}

}  // namespace

WalkSource make_walk_source(DrawModel model, const motion::MotionSpace& space,
                            const AdjectiveModel* adjectives) {
  switch (model) {
    case DrawModel::adjectives:
      return sliders(adjective_controls(adjectives, space.set));
    case DrawModel::features:
      return sliders(feature_controls(space.set));
    case DrawModel::weights:
      return {mixture_of_walks(space.set.size()), ""};
    case DrawModel::pca:
      return place_on_map(space);
    case DrawModel::examples:
      return {one_walk(space.set.size()), ""};
  }
  return {};
}

double usual_least_start(const motion::MotionSpace& space, const motion::PoseBank& bank,
                         const DrawWalk& draw, DistanceTimes times) {
  Task alone;
  alone.distance = times;
  const double far = motion::quantile(tried(bank, draw, times), 0.75);
  return std::min(far, automatic_threshold(space, alone) / start_margin);
}

int count_far_starts(const motion::PoseBank& bank, const DrawWalk& draw, DistanceTimes times,
                     double least_start_m) {
  const std::vector<double> starts = tried(bank, draw, times);
  return static_cast<int>(std::count_if(starts.begin(), starts.end(),
                                        [&](double start) { return start >= least_start_m; }));
}

int count_far_examples(const motion::PoseBank& bank, DistanceTimes times, double least_start_m) {
  int far = 0;
  for (int i = 0; i < bank.size(); ++i) {
    far += start_of(bank, VectorXd::Unit(bank.size(), i), times) >= least_start_m ? 1 : 0;
  }
  return far;
}

std::vector<int> farthest_points(const std::vector<DistancePoints>& points,
                                 const DistancePoints& start, int kept) {
  // D to the nearest that was taken; at first to the start.
  std::vector<double> nearest;
  for (const DistancePoints& one : points) {
    nearest.push_back(motion::distance(one, start).mean_m);
  }
  std::vector<int> taken;
  while (static_cast<int>(taken.size()) < std::min(kept, static_cast<int>(points.size()))) {
    const auto farthest = std::max_element(nearest.begin(), nearest.end());
    const auto index = static_cast<std::size_t>(farthest - nearest.begin());
    for (std::size_t i = 0; i < points.size(); ++i) {
      const double d = motion::distance(points[i], points[index]).mean_m;
      nearest[i] = taken.empty() ? d : std::min(nearest[i], d);
    }
    taken.push_back(static_cast<int>(index));
    for (const int one : taken) nearest[static_cast<std::size_t>(one)] = -1;
  }
  return taken;
}

std::vector<VectorXd> draw_targets(const motion::PoseBank& bank, const DrawWalk& draw,
                                   const DrawRules& rules, Rng& rng) {
  std::vector<VectorXd> walks;
  std::vector<DistancePoints> points;
  for (int i = 0; i < std::max(rules.draws, rules.kept); ++i) {
    walks.push_back(draw_far(bank, draw, rules, walks, rng));
    points.push_back(blend_points(bank, walks.back(), rules.times));
  }
  const DistancePoints start = blend_points(bank, equal_weights(bank.size()), rules.times);
  std::vector<VectorXd> kept;
  for (const int index : farthest_points(points, start, rules.kept)) {
    kept.push_back(walks[static_cast<std::size_t>(index)]);
  }
  rng.shuffle(kept);
  return kept;
}

}  // namespace promenade::study
