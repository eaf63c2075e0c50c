// Made-up trials for tests of what is computed from a Dataset.
#pragma once

#include <optional>
#include <string>

#include "analysis/dataset.h"

namespace promenade::analysis {

// One task, `match`, one measure, the time, and a trial for each person, interface and target:
// value(person, interface, target), no trial where that is nothing.
template <typename Value>
Dataset toy_dataset(int people, int interfaces, int targets, Value value) {
  Dataset data;
  data.measures = {{"time_s", "time", "s", "s", 1, 1}};
  data.tasks = {{"match", {}, 60.0, {}}};
  for (int t = 0; t < targets; ++t) data.tasks[0].targets.push_back("t" + std::to_string(t));
  for (int i = 0; i < interfaces; ++i) data.interfaces.push_back("i" + std::to_string(i));
  for (int p = 0; p < people; ++p) {
    data.people.push_back("P" + std::to_string(p));
    for (int i = 0; i < interfaces; ++i) {
      for (int t = 0; t < targets; ++t) {
        const std::optional<double> seconds = value(p, i, t);
        if (!seconds) continue;
        // At the limit it has failed.
        const bool failed = *seconds >= 60;
        data.trials.push_back({p, i, 0, t, 1, failed ? "timeout" : "success", failed, {seconds}});
      }
    }
  }
  return data;
}

}  // namespace promenade::analysis
