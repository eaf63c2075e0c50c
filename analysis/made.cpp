#include "analysis/made.h"

#include <algorithm>
#include <map>
#include <tuple>

#include "analysis/item.h"
#include "analysis/samples.h"
#include "motion/models/map.h"
#include "study/asked_quality.h"

namespace promenade::analysis {
namespace {

using Eigen::VectorXd;
using motion::DistancePoints;
using Values = std::vector<std::optional<double>>;  // one for each trial of the data
using Finals = std::vector<std::optional<VectorXd>>;

constexpr double same_m = 1e-9;     // an example blended from itself differs by rounding
constexpr double most_extreme = 2;  // of the scale of the ratings, at either end

// The task of the study, if it asks for a quality.
const study::Task* asking_task(const study::Study& study, const std::string& name) {
  const study::Task* const task = study::find_task(study, name);
  return task && task->kind == study::TaskKind::find ? task : nullptr;
}

// N: what each motion has of what a target asks for; empty: nobody was asked.
std::map<std::pair<int, int>, VectorXd> ratings_by_target(const Dataset& data,
                                                          const study::Study& study,
                                                          const study::AdjectiveModel& model) {
  std::map<std::pair<int, int>, VectorXd> ratings;
  for (int t = 0; t < size_of(data.tasks); ++t) {
    const Task& task = item(data.tasks, t);
    const study::Task* asked = asking_task(study, task.name);
    if (!asked) continue;
    for (const study::Target& target : asked->targets) {
      const auto at = std::find(task.targets.begin(), task.targets.end(), target.name);
      const auto pair = study::asked_pair(model.table.pairs, target);
      if (!pair || at == task.targets.end()) continue;
      ratings[{t, static_cast<int>(at - task.targets.begin())}] =
          study::asked_ratings(model, *pair);
    }
  }
  return ratings;
}

Values asked_quality(const Dataset& data, const study::Study& study,
                     const study::AdjectiveModel& model, const Finals& finals) {
  const auto ratings = ratings_by_target(data, study, model);
  Values values(data.trials.size());
  for (std::size_t i = 0; i < values.size(); ++i) {
    const auto asked = ratings.find({data.trials[i].task, data.trials[i].target});
    if (!finals[i] || asked == ratings.end() || asked->second.size() != finals[i]->size()) continue;
    const double mean = asked->second.dot(*finals[i]);
    if (std::isfinite(mean)) values[i] = std::clamp(mean, -most_extreme, most_extreme);
  }
  return values;
}

Values mahalanobis(const motion::MotionSpace& space, const Finals& finals) {
  Values values(finals.size());
  const motion::Pca pca = motion::principal_components(space);
  if (pca.components() == 0) return values;
  const VectorXd deviations = motion::make_minimap(pca).deviations;
  for (std::size_t i = 0; i < finals.size(); ++i) {
    if (!finals[i]) continue;
    const VectorXd at = motion::coordinates_of(pca, *finals[i]).head(deviations.size());
    values[i] = at.cwiseQuotient(deviations).norm();
  }
  return values;
}

std::vector<std::optional<DistancePoints>> points_of(const motion::PoseBank& bank,
                                                     const Finals& finals) {
  motion::PoseBlend blend = motion::make_pose_blend(bank);
  std::vector<std::optional<DistancePoints>> points(finals.size());
  for (std::size_t i = 0; i < finals.size(); ++i) {
    if (!finals[i]) continue;
    motion::set_weights(bank, *finals[i], blend);
    motion::distance_points(bank, blend, points[i].emplace());
  }
  return points;
}

Values novelty(const motion::MotionSet& set,
               const std::vector<std::optional<DistancePoints>>& points) {
  std::vector<DistancePoints> examples;
  for (const motion::Cycle& cycle : set.cycles) {
    examples.push_back(motion::distance_points(set, cycle));
  }
  Values values(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    for (const DistancePoints& example : examples) {
      if (!points[i]) break;
      const double d = motion::distance(*points[i], example).mean_m;
      values[i] = std::min(values[i].value_or(d), d);
    }
    if (values[i] && *values[i] < same_m) values[i] = 0;
  }
  return values;
}

// Several trials of one person are not compared with each other.
Values diversity(const Dataset& data, const std::vector<std::optional<DistancePoints>>& points) {
  std::map<std::tuple<int, int, int>, std::vector<std::size_t>> groups;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Trial& trial = data.trials[i];
    if (points[i]) groups[{trial.task, trial.interface, trial.target}].push_back(i);
  }
  Values values(points.size());
  for (const auto& [place, group] : groups) {
    for (const std::size_t i : group) {
      double sum = 0;
      int others = 0;
      for (const std::size_t j : group) {
        if (data.trials[i].person == data.trials[j].person) continue;
        sum += motion::distance(*points[i], *points[j]).mean_m;
        ++others;
      }
      if (others > 0) values[i] = sum / others;
    }
  }
  return values;
}

void add(Measure measure, const Values& values, Dataset& data) {
  data.measures.push_back(std::move(measure));
  for (std::size_t i = 0; i < values.size(); ++i) data.trials[i].values.push_back(values[i]);
}

}  // namespace

void add_measures_of_made(const Log& log, const study::StudyBundle* stored, Dataset& data) {
  if (!stored) return;
  std::vector<bool> find;
  for (const Task& task : data.tasks) {
    find.push_back(asking_task(stored->study, task.name) != nullptr);
  }
  if (std::find(find.begin(), find.end(), true) == find.end()) return;
  const Finals finals = final_weights(log, data, *stored, find);
  const auto points = points_of(stored->bank, finals);
  if (const auto model = study::rated_adjectives(*stored)) {
    const Values values = asked_quality(data, stored->study, *model, finals);
    const std::string label =
        model->simulated() ? "asked quality (simulated raters)" : "asked quality";
    if (!present(values).empty()) {
      add({"asked_quality", label, "", "", 1, 2, MeasureKind::result}, values, data);
    }
  }
  const std::string of_made = "of what was made: ";
  add({"novelty_m", of_made + "D to the nearest example", "m", "cm", 100, 1, MeasureKind::result},
      novelty(stored->space.set, points), data);
  add({"mahalanobis", of_made + "distance from the average", "SD", "SD", 1, 2, MeasureKind::result},
      mahalanobis(stored->space, finals), data);
  add({"diversity_m", of_made + "D to what others made", "m", "cm", 100, 1, MeasureKind::result},
      diversity(data, points), data);
}

}  // namespace promenade::analysis
