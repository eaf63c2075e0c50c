#include "study/reach_models.h"

#include <algorithm>
#include <cassert>

#include "study/asked_quality.h"
#include "study/map_options.h"
#include "study/rng.h"

namespace promenade::study {
namespace {

using Eigen::VectorXd;

constexpr motion::SearchOptions search_options{
    .first_step = 0.15, .smallest_step = 1e-3, .evaluations = 600};

void take(ControlMapOrReason found, const char* name, ReachModels& models) {
  if (found.map) return models.maps.push_back(std::move(*found.map));
  models.missing.push_back({name, found.reason});
}

// The sliders of the adjectives, or why there are none.
void add_adjectives(const motion::MotionSet& set, ReachModels& models) {
  if (models.predicted) {
    models.maps.push_back(
        motion::slider_controls("adjectives", models.predicted->names, models.predicted->primary));
    return;
  }
  const auto& model = models.adjectives;
  take(adjective_controls(model ? &*model : nullptr, set), "adjectives", models);
}

// Those of the first map of the study; the standards when it has none.
motion::MapOptions options_of_map(const Study& study) {
  for (const InterfaceUse& use : study.interfaces) {
    if (use.type == "map") return map_options(use.parameters);
  }
  return {};
}

// Everything about the motions, behind what is known of their adjectives.
ReachModels completed(const StudyBundle& bundle, ReachModels models) {
  const motion::MotionSet& set = bundle.space.set;
  models.bank = bundle.bank;
  add_adjectives(set, models);
  take(feature_controls(set), "features", models);
  models.maps.push_back(motion::label_controls(set));
  if (auto map = motion::map_controls(bundle.space, options_of_map(bundle.study))) {
    models.maps.push_back(std::move(*map));
  } else {
    models.missing.push_back({"map", "all cycles of the set are alike"});
  }
  models.maps.push_back(motion::weight_controls(set));
  return models;
}

}  // namespace

ControlMapOrReason adjective_controls(const AdjectiveModel* model, const motion::MotionSet& set) {
  if (!model) return {{}, "nobody has rated the motions of this set"};
  if (model->table.motions != names_of(set)) return {{}, "the ratings are of other motions"};
  const Eigen::MatrixXd& primary = model->quantification.primary;
  if (primary.rows() == 0) return {{}, describe(model->agreement)};
  return {motion::slider_controls("adjectives", model->names, primary), ""};
}

ControlMapOrReason feature_controls(const motion::MotionSet& set) {
  if (set.size() < 2) return {{}, "the set has one cycle"};
  const motion::FeatureSliders sliders = motion::feature_sliders(set);
  return {motion::slider_controls("features", sliders.names, sliders.parameters), ""};
}

ReachModels make_reach_models(const StudyBundle& bundle, std::optional<AdjectiveModel> adjectives) {
  ReachModels models;
  models.adjectives = adjectives ? std::move(adjectives) : rated_adjectives(bundle);
  return completed(bundle, std::move(models));
}

ReachModels make_reach_models(const StudyBundle& bundle, PredictedAdjectives predicted) {
  ReachModels models;
  models.predicted = std::move(predicted);
  return completed(bundle, std::move(models));
}

const motion::ControlMap* find_map(const ReachModels& models, std::string_view type) {
  const auto found = std::find_if(models.maps.begin(), models.maps.end(),
                                  [&](const motion::ControlMap& map) { return map.name == type; });
  return found == models.maps.end() ? nullptr : &*found;
}

Reach reach(const ReachModels& models, const motion::ControlMap& map, const Target& target,
            double threshold_m, DistanceTimes times) {
  assert(target.weights && "only a target motion can be reached");
  const motion::DistancePoints wanted = blend_points(models.bank, *target.weights, times);
  Rng rng(1, 0, "reach");
  const motion::Reach found =
      motion::reach(models.bank, wanted, motion::problem_of(map, *target.weights),
                    [&rng] { return rng.uniform(); },
                    {.threshold_m = threshold_m, .times = times, .search = search_options});
  Reach result{found.start_m, found.best_m, INFINITY, found.share_below,
               static_cast<int>(found.random_m.size())};
  for (int i = 0; i < models.bank.size(); ++i) {
    const auto example = blend_points(models.bank, VectorXd::Unit(models.bank.size(), i), times);
    result.best_example = std::min(result.best_example, motion::distance(wanted, example).mean_m);
  }
  if (map.shows_examples) result.best = std::min(result.best, result.best_example);
  return result;
}

Reach reach(const StudyBundle& bundle, const InterfaceRegistry& registry, const ReachModels& models,
            const Task& task, int interface, const Target& target, double threshold_m) {
  const std::string& type = bundle.study.interfaces[static_cast<std::size_t>(interface)].type;
  if (const motion::ControlMap* map = find_map(models, type)) {
    return reach(models, *map, target, threshold_m, task.distance);
  }
  return reach(bundle, registry, task, interface, target, {.threshold_m = threshold_m});
}

double judged_threshold(const motion::MotionSpace& space, const Task& task) {
  return task.threshold_m ? *task.threshold_m : automatic_threshold(space, task);
}

}  // namespace promenade::study
