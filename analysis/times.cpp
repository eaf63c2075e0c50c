#include "analysis/times.h"

#include <algorithm>

#include "analysis/item.h"
#include "analysis/statistics/p_adjust.h"

namespace promenade::analysis {
namespace {

struct TimedTrial {
  int interface = 0, person = 0;
  Duration duration;
};

std::vector<TimedTrial> timed_trials(const Dataset& data, int task) {
  const int time = data.measure("time_s");
  std::vector<TimedTrial> timed;
  if (time < 0) return timed;
  for (const Trial& trial : data.trials) {
    const std::optional<double>& seconds = item(trial.values, time);
    if (trial.task != task || !seconds) continue;
    timed.push_back({trial.interface, trial.person, {*seconds, !trial.failed}});
  }
  return timed;
}

// Up to where each interface has a trial.
double known_to_all(const std::vector<TimeCurve>& curves) {
  double horizon = curves[0].survival.steps.back().time;
  for (const TimeCurve& curve : curves) {
    horizon = std::min(horizon, curve.survival.steps.back().time);
  }
  return horizon;
}

std::vector<TimeCurve> curves_of(const std::vector<TimedTrial>& timed, int interfaces) {
  std::vector<TimeCurve> curves;
  for (int i = 0; i < interfaces; ++i) {
    TimeCurve curve;
    curve.interface = i;
    std::vector<Duration> durations;
    for (const TimedTrial& one : timed) {
      if (one.interface != i) continue;
      durations.push_back(one.duration);
      curve.done += one.duration.done ? 1 : 0;
    }
    curve.trials = size_of(durations);
    if (durations.empty()) continue;
    curve.survival = kaplan_meier(std::move(durations));
    curve.median_ci = median_time_interval(curve.survival);
    curves.push_back(std::move(curve));
  }
  return curves;
}

// Groups are places in `interfaces`.
LogRankTest compare(const std::vector<TimedTrial>& timed, const std::vector<int>& interfaces) {
  std::vector<GroupedDuration> grouped;
  for (const TimedTrial& one : timed) {
    const auto place = std::find(interfaces.begin(), interfaces.end(), one.interface);
    if (place == interfaces.end()) continue;
    grouped.push_back({one.duration, static_cast<int>(place - interfaces.begin()), one.person});
  }
  return logrank(std::move(grouped), size_of(interfaces));
}

void add_pairs(TaskTimes& times, const std::vector<TimedTrial>& timed) {
  std::vector<double> p;
  for (std::size_t a = 0; a < times.curves.size(); ++a) {
    for (std::size_t b = a + 1; b < times.curves.size(); ++b) {
      TimePair pair{times.curves[a].interface, times.curves[b].interface, {}, {}, 0};
      pair.test = compare(timed, {pair.a, pair.b});
      if (pair.test.p) p.push_back(*pair.test.p);
      times.pairs.push_back(std::move(pair));
    }
  }
  const std::vector<double> adjusted = adjust_holm(p);
  std::size_t next = 0;
  for (TimePair& pair : times.pairs) {
    pair.family = size_of(p);
    if (pair.test.p) pair.p_holm = adjusted[next++];
  }
}

// No curve where no trial of the task has a time.
TaskTimes times_of(const Dataset& data, int task) {
  const std::vector<TimedTrial> timed = timed_trials(data, task);
  TaskTimes times;
  times.task = task;
  times.curves = curves_of(timed, size_of(data.interfaces));
  if (times.curves.empty()) return times;
  const std::optional<double> limit = item(data.tasks, task).limit_s;
  times.to_limit = limit.has_value();
  times.horizon = limit ? *limit : known_to_all(times.curves);
  std::vector<int> interfaces;
  for (TimeCurve& curve : times.curves) {
    curve.restricted = restricted_mean(curve.survival, times.horizon);
    interfaces.push_back(curve.interface);
  }
  times.test = compare(timed, interfaces);
  add_pairs(times, timed);
  return times;
}

}  // namespace

std::vector<TaskTimes> task_times(const Dataset& data) {
  std::vector<TaskTimes> all;
  for (int task = 0; task < size_of(data.tasks); ++task) {
    TaskTimes times = times_of(data, task);
    if (!times.curves.empty()) all.push_back(std::move(times));
  }
  return all;
}

}  // namespace promenade::analysis
