#include "motion/models/reach.h"

#include <algorithm>
#include <cassert>
#include <iterator>

namespace promenade::motion {
namespace {

using Eigen::VectorXd;

// D of one blend after another, in the same buffers.
class Meter {
 public:
  Meter(const PoseBank& bank, const DistancePoints& target, DistanceTimes times)
      : bank_(bank),
        target_(target),
        times_(times),
        blend_(make_pose_blend(bank)),
        weights_(bank.size()) {}

  double of_weights(const VectorXd& weights) {
    set_weights(bank_, weights, blend_);
    distance_points(bank_, blend_, points_, times_);
    return distance(points_, target_).mean_m;
  }
  double of_parameters(const WeightsMap& map, const VectorXd& parameters) {
    map(parameters, weights_);
    return of_weights(weights_);
  }

 private:
  const PoseBank& bank_;
  const DistancePoints& target_;
  DistanceTimes times_;
  PoseBlend blend_;
  VectorXd weights_;
  DistancePoints points_;
};

VectorXd drawn(const Box& box, const std::function<double()>& uniform) {
  VectorXd at(box.size());
  for (int d = 0; d < box.size(); ++d) at(d) = box.low(d) + uniform() * (box.high(d) - box.low(d));
  return at;
}

struct Setting {
  VectorXd at;
  double d = 0;
};

void sort_by_distance(std::vector<Setting>& settings) {
  std::stable_sort(settings.begin(), settings.end(),
                   [](const Setting& a, const Setting& b) { return a.d < b.d; });
}

void keep_best(std::vector<Setting>& settings, std::size_t count) {
  sort_by_distance(settings);
  settings.resize(std::min(settings.size(), count));
}

void note_share(const ReachOptions& options, Reach& result) {
  const auto below = std::count_if(result.random_m.begin(), result.random_m.end(),
                                   [&](double d) { return d < options.threshold_m; });
  const std::size_t count = std::max<std::size_t>(1, result.random_m.size());
  result.share_below = static_cast<double>(below) / static_cast<double>(count);
}

void try_choices(const ReachProblem& problem, Meter& meter, Reach& result) {
  for (const VectorXd& weights : problem.choices) {
    result.random_m.push_back(meter.of_weights(weights));
  }
  const auto best = std::min_element(result.random_m.begin(), result.random_m.end());
  result.best_m = *best;
  result.best_at =
      VectorXd::Constant(1, static_cast<double>(std::distance(result.random_m.begin(), best)));
}

// The middle of the box, the best guesses, the best random settings.
std::vector<Setting> beginnings(const ReachProblem& problem, Meter& meter,
                                const std::function<double()>& uniform, const ReachOptions& options,
                                Reach& result) {
  const auto measured = [&](const VectorXd& at) -> Setting {
    return {at, meter.of_parameters(problem.weights, at)};
  };
  std::vector<Setting> random, guesses;
  for (int i = 0; i < options.random_settings; ++i) {
    random.push_back(measured(drawn(problem.box, uniform)));
    result.random_m.push_back(random.back().d);
  }
  for (const VectorXd& guess : problem.guesses) {
    guesses.push_back(measured(guess.cwiseMax(problem.box.low).cwiseMin(problem.box.high)));
  }
  const auto searches = static_cast<std::size_t>(std::max(1, options.searches));
  std::vector<Setting> from = {measured(0.5 * (problem.box.low + problem.box.high))};
  keep_best(guesses, std::min<std::size_t>(2, searches - 1));
  keep_best(random, searches - 1 - guesses.size());
  from.insert(from.end(), guesses.begin(), guesses.end());
  from.insert(from.end(), random.begin(), random.end());
  return from;
}

}  // namespace

Reach reach(const PoseBank& bank, const DistancePoints& target, const ReachProblem& problem,
            const std::function<double()>& uniform, const ReachOptions& options) {
  assert(problem.start.size() == bank.size() && "one weight for each cycle");
  Meter meter(bank, target, options.times);
  Reach result;
  result.start_m = meter.of_weights(problem.start);
  if (!problem.choices.empty()) {
    try_choices(problem, meter, result);
    note_share(options, result);
    return result;
  }
  const Objective objective = [&](const VectorXd& at) {
    return meter.of_parameters(problem.weights, at);
  };
  bool first = true;
  for (const Setting& from : beginnings(problem, meter, uniform, options, result)) {
    const SearchResult found = minimise(objective, problem.box, from.at, options.search);
    if (!first && found.value >= result.best_m) continue;
    first = false;
    result.best_m = found.value;
    result.best_at = found.at;
  }
  note_share(options, result);
  return result;
}

}  // namespace promenade::motion
