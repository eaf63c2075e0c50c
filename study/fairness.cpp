#include "study/fairness.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "motion/quantile.h"

namespace promenade::study {
namespace {

using motion::DistancePoints;

DistancePoints points_of(const motion::MotionSpace& space, const Eigen::VectorXd& weights,
                         DistanceTimes times) {
  return motion::distance_points(space.set, motion::blend(space, weights), times);
}

std::vector<DistancePoints> example_points(const motion::MotionSpace& space, DistanceTimes times) {
  std::vector<DistancePoints> points;
  for (const motion::Cycle& cycle : space.set.cycles) {
    points.push_back(motion::distance_points(space.set, cycle, times));
  }
  return points;
}

bool has_several_styles(const motion::MotionSet& set) {
  return std::any_of(set.cycles.begin(), set.cycles.end(), [&](const motion::Cycle& cycle) {
    return cycle.style != set.cycles.front().style;
  });
}

// One interface in search of one target.
class Search {
 public:
  Search(const motion::MotionSpace& space, const InterfaceType& type, const InterfaceUse& use,
         const Eigen::VectorXd& target, DistanceTimes times)
      : space_(space),
        type_(type),
        times_(times),
        target_(points_of(space, target, times)),
        start_(type.start({space, use.parameters, start_weights(space), 1, use.model})),
        rng_(1, 0, "reach") {}

  double distance_of(const InterfaceState& state) const {
    return motion::distance(target_, points_of(space_, weights_of(state, settled_us), times_))
        .mean_m;
  }

  // A setting that someone might be at: a few proposals taken one after another.
  std::unique_ptr<InterfaceState> wander() {
    std::unique_ptr<InterfaceState> state = start_->clone();
    const std::uint64_t steps = 1 + rng_.below(8);
    for (std::uint64_t i = 0; i < steps; ++i) {
      const auto proposals = type_.simulate(*state, rng_);
      if (proposals.empty()) break;
      state->apply(proposals[rng_.below(proposals.size())]);
    }
    return state;
  }

  // Takes the best proposal as long as there is a better one.
  double descend(std::unique_ptr<InterfaceState> state, int rounds) {
    double best = distance_of(*state);
    for (int idle = 0; idle < rounds && idle < 8;) {
      std::unique_ptr<InterfaceState> next = best_step(*state, best);
      idle = next ? 0 : idle + 1;
      if (next) state = std::move(next);
      --rounds;
    }
    return best;
  }

 private:
  std::unique_ptr<InterfaceState> best_step(const InterfaceState& from, double& best) {
    std::unique_ptr<InterfaceState> found;
    for (const ControlInput& proposal : type_.simulate(from, rng_)) {
      std::unique_ptr<InterfaceState> next = from.clone();
      if (next->apply(proposal) != Applied::done) continue;
      const double d = distance_of(*next);
      if (d >= best) continue;
      best = d;
      found = std::move(next);
    }
    return found;
  }

  const motion::MotionSpace& space_;
  const InterfaceType& type_;
  DistanceTimes times_;
  DistancePoints target_;
  std::unique_ptr<InterfaceState> start_;
  Rng rng_;
};

}  // namespace

double weights_distance(const motion::MotionSpace& space, const Eigen::VectorXd& a,
                        const Eigen::VectorXd& b, DistanceTimes times) {
  return motion::distance(points_of(space, a, times), points_of(space, b, times)).mean_m;
}

DistancePoints blend_points(const motion::PoseBank& bank, const Eigen::VectorXd& weights,
                            DistanceTimes times) {
  motion::PoseBlend blend = motion::make_pose_blend(bank);
  motion::set_weights(bank, weights, blend);
  DistancePoints points;
  motion::distance_points(bank, blend, points, times);
  return points;
}

double start_distance(const motion::MotionSpace& space, const Eigen::VectorXd& target,
                      DistanceTimes times) {
  return weights_distance(space, start_weights(space), target, times);
}

double median_style_distance(const motion::MotionSpace& space, DistanceTimes times) {
  const bool several = has_several_styles(space.set);
  const std::vector<DistancePoints> points = example_points(space, times);
  std::vector<double> distances;
  for (std::size_t i = 0; i < points.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      if (several && space.set.cycles[i].style == space.set.cycles[j].style) continue;
      distances.push_back(motion::distance(points[i], points[j]).mean_m);
    }
  }
  return distances.empty() ? 0 : motion::quantile(std::move(distances), 0.5);
}

double automatic_threshold(const motion::MotionSpace& space, const Task& task) {
  double threshold = 0.5 * median_style_distance(space, task.distance);
  for (const std::vector<Target>* targets : {&task.targets, &task.practice}) {
    for (const Target& target : *targets) {
      if (target.draw) threshold = std::min(threshold, start_margin * target.least_start_m);
      if (!target.weights) continue;
      threshold =
          std::min(threshold, start_margin * start_distance(space, *target.weights, task.distance));
    }
  }
  return threshold;
}

Reach reach(const StudyBundle& bundle, const InterfaceRegistry& registry, const Task& task,
            int interface, const Target& target, const ReachOptions& options) {
  assert(target.weights && "only a target motion can be reached");
  const motion::MotionSpace& space = bundle.space;
  const InterfaceUse& use = bundle.study.interfaces[static_cast<std::size_t>(interface)];
  Search search(space, *registry.find(use.type), use, *target.weights, task.distance);
  Reach result;
  result.start = start_distance(space, *target.weights, task.distance);
  result.settings = options.settings;
  result.best = INFINITY;
  std::unique_ptr<InterfaceState> best_state;
  int below = 0;
  for (int i = 0; i < options.settings; ++i) {
    std::unique_ptr<InterfaceState> state = search.wander();
    const double d = search.distance_of(*state);
    below += d < options.threshold_m;
    if (d >= result.best) continue;
    result.best = d;
    best_state = std::move(state);
  }
  if (best_state) result.best = search.descend(std::move(best_state), options.rounds);
  if (options.settings > 0) {
    result.share_below = static_cast<double>(below) / options.settings;
  }
  const DistancePoints wanted = points_of(space, *target.weights, task.distance);
  result.best_example = INFINITY;
  for (const DistancePoints& example : example_points(space, task.distance)) {
    result.best_example = std::min(result.best_example, motion::distance(wanted, example).mean_m);
  }
  return result;
}

}  // namespace promenade::study
