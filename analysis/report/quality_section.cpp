// Data quality: late frames, time stamps, what was interrupted, and what has no outcome.
#include <fmt/format.h>

#include "analysis/format.h"
#include "analysis/item.h"
#include "analysis/report/cells.h"
#include "analysis/report/rating_tables.h"
#include "analysis/report/report_sections.h"

namespace promenade::analysis {
namespace {

std::string name_of(const Dataset& data, int interface) {
  return interface < 0 ? "all" : item(data.interfaces, interface);
}

Table count_table(const Results& results) {
  Table table{"quality_counts",
              "How well the trials ran, in all and for each interface.",
              {"interface", "trials", "flagged", "interrupted", "paused", "slow_frames",
               "coarse_time", "late_frames", "minutes", "late_frames_per_minute",
               "uncertainty_ms_median", "uncertainty_ms_largest", "skipped", "aborted", "cut_off"},
              {}};
  for (const QualityCount& one : results.quality.counts) {
    table.rows.push_back({cell(name_of(results.data, one.interface)), cell(one.trials),
                          cell(one.flagged), cell(one.interrupted), cell(one.paused),
                          cell(one.slow_frames), cell(one.coarse_time), cell(one.late_frames),
                          cell(std::optional(one.minutes)), cell(one.late_per_minute),
                          cell(one.median_uncertainty_ms), cell(one.largest_uncertainty_ms),
                          cell(one.skipped), cell(one.aborted), cell(one.cut_off)});
  }
  return table;
}

Table trial_table(const Results& results) {
  const Dataset& data = results.data;
  Table table{
      "quality",
      "Every trial that counts, and why it is better left out of a sensitivity analysis.",
      {"participant", "session", "trial", "position", "interface", "task", "target", "late_frames",
       "uncertainty_ms", "interrupted", "paused", "slow_frames", "coarse_time", "flagged"},
      {}};
  for (const Trial& trial : data.trials) {
    const TrialQuality& quality = trial.quality;
    const LoggedTrial& logged = item(results.log.trials, trial.logged);
    table.rows.push_back({cell(item(data.people, trial.person)),
                          cell(item(results.log.sessions, logged.session).uuid), cell(logged.uuid),
                          cell(trial.position), cell(item(data.interfaces, trial.interface)),
                          cell(logged.task), cell(logged.target), cell(quality.late_frames),
                          cell(std::optional(quality.uncertainty_ms)), cell(quality.interrupted),
                          cell(quality.paused), cell(quality.slow_frames),
                          cell(quality.coarse_time), cell(quality.flagged())});
  }
  return table;
}

HtmlTable shown_table(const Results& results) {
  HtmlTable table;
  table.caption =
      "Trials by interface. Flagged: interrupted, paused, more than one late frame a second, or an "
      "input whose time is known to 50 ms or worse. Left out: skipped, aborted or cut off.";
  table.columns = {"interface",
                   "trials",
                   "flagged",
                   "share",
                   "late frames",
                   "a minute",
                   "time uncertainty: median",
                   "largest",
                   "interrupted",
                   "paused",
                   "left out"};
  for (const QualityCount& one : results.quality.counts) {
    table.rows.push_back({name_of(results.data, one.interface), std::to_string(one.trials),
                          std::to_string(one.flagged), percent_of(one.flagged, one.trials),
                          std::to_string(one.late_frames), number_cell(one.late_per_minute, 1),
                          number_cell(one.median_uncertainty_ms, 1) + " ms",
                          number_cell(one.largest_uncertainty_ms, 1) + " ms",
                          std::to_string(one.interrupted), std::to_string(one.paused),
                          std::to_string(one.skipped + one.aborted + one.cut_off)});
    table.strong.push_back(one.interface < 0);
  }
  return table;
}

std::string sentence_on(const Results& results) {
  const QualityCount& all = results.quality.counts[0];
  std::string sentence =
      fmt::format("{} of {} flagged.", all.flagged, count_of(all.trials, "trial is", "trials are"));
  if (results.quality.resumed_sessions == 0) return sentence + " No session was interrupted.";
  return sentence + fmt::format(" {} went on after an interruption ({} in all).",
                                count_of(results.quality.resumed_sessions, "session", "sessions"),
                                count_of(results.quality.resumptions, "time", "times"));
}

// Of those with an interface.
void add_trials(const Results& results, Section& section) {
  const Table counts = count_table(results);
  section.html = element("p", sentence_on(results)) + wide(shown_table(results));
  section.json["quality"] = {{"counts", json_rows(counts)},
                             {"resumed_sessions", results.quality.resumed_sessions},
                             {"resumptions", results.quality.resumptions}};
  section.tables = {counts, trial_table(results)};
}

}  // namespace

Section quality_section(const Results& results) {
  const bool made = !results.data.trials.empty();
  Section section;
  if (made || !results.ratings.motions.empty()) section.title = "Data quality";
  if (made) add_trials(results, section);
  add_rating_quality(results, section);
  return section;
}

}  // namespace promenade::analysis
