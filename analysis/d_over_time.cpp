#include "analysis/d_over_time.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "analysis/item.h"
#include "motion/quantile.h"
#include "study/migrate.h"
#include "study/sqlite.h"

namespace promenade::analysis {
namespace {

constexpr int points = 101;

Trace read_trace(study::Statement& samples, const LoggedTrial& logged) {
  Trace trace;
  samples.reset();
  samples.bind(1, logged.uuid);
  while (samples.step()) {
    if (samples.is_null(1) || !std::isfinite(samples.real(1))) continue;
    const auto since = static_cast<double>(samples.integer(0) - logged.started_us);
    trace.times_s.push_back(std::max(0.0, since / 1e6));
    trace.d.push_back(samples.real(1));
  }
  return trace;
}

double duration_s(const LoggedTrial& logged) {
  return static_cast<double>(logged.ended_us.value_or(logged.started_us) - logged.started_us) / 1e6;
}

// One trace for each trial of the data; empty where there is none. Each file is opened once.
std::vector<Trace> traces_of(const Results& results) {
  const auto& trials = results.data.trials;
  std::vector<Trace> traces(trials.size());
  for (int file = 0; file < size_of(results.log.files); ++file) {
    study::Database database = study::open_log(item(results.log.files, file).file);
    study::Statement samples(database,
                             "SELECT t_us, d FROM sample WHERE trial = ? ORDER BY t_us, rowid");
    for (std::size_t i = 0; i < trials.size(); ++i) {
      const LoggedTrial& logged = item(results.log.trials, trials[i].logged);
      if (item(results.log.sessions, logged.session).file != file) continue;
      traces[i] = read_trace(samples, logged);
    }
  }
  return traces;
}

}  // namespace

std::optional<double> d_at(const Trace& trace, double time_s) {
  const auto after = std::upper_bound(trace.times_s.begin(), trace.times_s.end(), time_s);
  if (after == trace.times_s.begin()) return std::nullopt;
  return trace.d[static_cast<std::size_t>(after - trace.times_s.begin()) - 1];
}

Curve curve_of(const std::vector<Trace>& traces, double end_s, int count) {
  Curve curve;
  for (const Trace& trace : traces) curve.trials += d_at(trace, 0) ? 1 : 0;
  if (curve.trials == 0) return curve;
  for (int k = 0; k < count; ++k) {
    const double time = end_s * k / (count - 1);
    std::vector<double> d;
    for (const Trace& trace : traces) {
      if (d_at(trace, 0)) d.push_back(*d_at(trace, time));
    }
    std::sort(d.begin(), d.end());
    curve.times_s.push_back(time);
    curve.lower_quartile.push_back(motion::quantile_of_sorted(d, 0.25));
    curve.median.push_back(motion::quantile_of_sorted(d, 0.5));
    curve.upper_quartile.push_back(motion::quantile_of_sorted(d, 0.75));
  }
  return curve;
}

Curves curves_of(const Results& results) {
  Curves result;
  const auto& trials = results.data.trials;
  std::vector<Trace> traces = traces_of(results);
  std::map<std::pair<int, int>, std::vector<Trace>> groups;  // by task and interface
  std::map<int, double> ends_s;
  for (std::size_t i = 0; i < trials.size(); ++i) {
    if (trials[i].quality.paused || trials[i].quality.interrupted) {
      ++result.paused;
      continue;
    }
    const LoggedTrial& logged = item(results.log.trials, trials[i].logged);
    ends_s[trials[i].task] = std::max(ends_s[trials[i].task], duration_s(logged));
    groups[{trials[i].task, trials[i].interface}].push_back(std::move(traces[i]));
  }
  for (const auto& [place, group] : groups) {
    Curve curve = curve_of(group, ends_s[place.first], points);
    curve.task = place.first;
    curve.interface = place.second;
    if (curve.trials > 0) result.curves.push_back(std::move(curve));
  }
  return result;
}

}  // namespace promenade::analysis
