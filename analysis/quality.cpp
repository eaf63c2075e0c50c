#include "analysis/quality.h"

#include <algorithm>

#include "analysis/item.h"
#include "analysis/statistics/median.h"

namespace promenade::analysis {
namespace {

void add(const TrialQuality& quality, QualityCount& count) {
  ++count.trials;
  count.flagged += quality.flagged() ? 1 : 0;
  count.interrupted += quality.interrupted ? 1 : 0;
  count.paused += quality.paused ? 1 : 0;
  count.slow_frames += quality.slow_frames ? 1 : 0;
  count.coarse_time += quality.coarse_time ? 1 : 0;
  count.late_frames += quality.late_frames;
}

QualityCount count_trials(const Log& log, const Dataset& data, int interface) {
  QualityCount count;
  count.interface = interface;
  std::vector<double> uncertainties;
  std::int64_t worked_us = 0;
  for (const Trial& trial : data.trials) {
    if (interface >= 0 && trial.interface != interface) continue;
    add(trial.quality, count);
    uncertainties.push_back(trial.quality.uncertainty_ms);
    const LoggedTrial& logged = item(log.trials, trial.logged);
    worked_us += logged.ended_us.value_or(logged.started_us) - logged.started_us;
  }
  count.minutes = static_cast<double>(worked_us) / 60e6;
  if (worked_us > 0) count.late_per_minute = count.late_frames / count.minutes;
  count.median_uncertainty_ms = median_of(uncertainties);
  if (uncertainties.empty()) return count;
  count.largest_uncertainty_ms = *std::max_element(uncertainties.begin(), uncertainties.end());
  return count;
}

// What the data set leaves out of the sessions that count.
void add_left_out(const LoggedTrial& trial, QualityCount& count) {
  count.skipped += trial.outcome == "skipped" ? 1 : 0;
  count.aborted += trial.outcome == "aborted" ? 1 : 0;
  count.cut_off += trial.outcome.empty() ? 1 : 0;
}

void count_left_out(const Log& log, const Dataset& data, const std::vector<bool>& counts,
                    Quality& quality) {
  for (const LoggedTrial& trial : log.trials) {
    if (!counts[static_cast<std::size_t>(trial.session)]) continue;
    add_left_out(trial, quality.counts[0]);
    for (QualityCount& count : quality.counts) {
      if (count.interface < 0 || item(data.interfaces, count.interface) != trial.interface)
        continue;
      add_left_out(trial, count);
    }
  }
}

}  // namespace

Quality quality_of(const Log& log, const Selection& selection, const Dataset& data) {
  Quality quality;
  for (int i = -1; i < size_of(data.interfaces); ++i) {
    quality.counts.push_back(count_trials(log, data, i));
  }
  std::vector<bool> counts(log.sessions.size(), false);
  for (const Person& person : selection.people) {
    if (person.disposition != Disposition::analysed) continue;
    counts[static_cast<std::size_t>(person.session)] = true;
    const int resumed = item(log.sessions, person.session).resumed;
    quality.resumed_sessions += resumed > 0 ? 1 : 0;
    quality.resumptions += resumed;
  }
  count_left_out(log, data, counts, quality);
  return quality;
}

}  // namespace promenade::analysis
