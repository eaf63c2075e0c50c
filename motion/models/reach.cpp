#include "motion/models/reach.h"

#include <algorithm>
#include <cassert>
#include <numeric>

namespace promenade::motion {
namespace {

using Eigen::VectorXd;

// D of one blend after another, in the same buffers.
class Meter {
 public:
  Meter(const PoseBank& bank, const DistancePoints& target)
      : bank_(bank), target_(target), blend_(make_pose_blend(bank)), weights_(bank.size()) {}

  double of_weights(const VectorXd& weights) {
    set_weights(bank_, weights, blend_);
    distance_points(bank_, blend_, points_);
    return distance(points_, target_).mean_m;
  }
  double of_parameters(const WeightsMap& map, const VectorXd& parameters) {
    map(parameters, weights_);
    return of_weights(weights_);
  }

 private:
  const PoseBank& bank_;
  const DistancePoints& target_;
  PoseBlend blend_;
  VectorXd weights_;
  DistancePoints points_;
};

VectorXd drawn(const Box& box, const std::function<double()>& uniform) {
  VectorXd at(box.size());
  for (int d = 0; d < box.size(); ++d) at(d) = box.low(d) + uniform() * (box.high(d) - box.low(d));
  return at;
}

}  // namespace

Reach reach(const PoseBank& bank, const DistancePoints& target, const ReachProblem& problem,
            const std::function<double()>& uniform, const ReachOptions& options) {
  assert(problem.start.size() == bank.size() && "one weight for each cycle");
  Meter meter(bank, target);
  Reach result;
  result.start_m = meter.of_weights(problem.start);
  std::vector<VectorXd> settings;
  for (int i = 0; i < options.random_settings; ++i) {
    settings.push_back(drawn(problem.box, uniform));
    result.random_m.push_back(meter.of_parameters(problem.weights, settings.back()));
  }
  const auto below = std::count_if(result.random_m.begin(), result.random_m.end(),
                                   [&](double d) { return d < options.threshold_m; });
  result.share_below =
      settings.empty() ? 0 : static_cast<double>(below) / static_cast<double>(settings.size());

  std::vector<std::size_t> order(settings.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&result](std::size_t a, std::size_t b) {
    return result.random_m[a] < result.random_m[b];
  });
  const Objective objective = [&](const VectorXd& at) {
    return meter.of_parameters(problem.weights, at);
  };
  for (int i = 0; i < std::max(1, options.searches); ++i) {
    const auto rank = static_cast<std::size_t>(i);
    if (rank > order.size()) break;
    const VectorXd from =
        i == 0 ? VectorXd(0.5 * (problem.box.low + problem.box.high)) : settings[order[rank - 1]];
    const SearchResult found = minimise(objective, problem.box, from, options.search);
    if (i > 0 && found.value >= result.best_m) continue;
    result.best_m = found.value;
    result.best_at = found.at;
  }
  return result;
}

}  // namespace promenade::motion
