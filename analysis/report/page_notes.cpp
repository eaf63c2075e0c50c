// How it was computed, and from what.
#include <fmt/format.h>

#include "analysis/format.h"
#include "analysis/item.h"
#include "analysis/report/page_parts.h"
#include "analysis/report/tables.h"

namespace promenade::analysis {
namespace {

constexpr const char* methods[] = {
    ("Who counts. The first finished session of each participant. Practice trials, pilot and "
     "simulated sessions are left out unless asked for; people who declined, withdrew or did not "
     "finish are counted in the flow only. Trials that were skipped, aborted or cut off are "
     "missing."),
    ("Measures. D is the mean distance between the joints of the target and of the created walk "
     "over one cycle; D at the start, the smallest shown, and final, when the trial ended. Time "
     "runs from the start of a trial to its end and is restricted to the limit; a failure (time "
     "limit, or Done with D above the threshold) counts with the time at which it ended, that is, "
     "censored there. Ratings count only if the person set them."),
    ("Comparisons. Wilcoxon's signed-rank test on the differences a − b of each pair of "
     "interfaces, in the order of the study. Zeros are dropped, ties get midranks, and p comes "
     "from the exact conditional distribution given these ranks, two-sided by doubling. The normal "
     "p beside it is without continuity correction. Magnitudes that differ by less than 1e-9 "
     "of the largest value are ties. r is the matched-pairs rank-biserial correlation "
     "(W+ − W−)/(W+ + W−)."),
    ("Size. The difference is the Hodges-Lehmann estimate, the median of all Walsh averages of all "
     "differences, zeros included, with the interval that belongs to the test: its level is at "
     "least 95 %, and there is none for fewer than six. The intervals of medians are those of the "
     "sign test, of failure ratios Wilson's."),
    ("Many tests. Holm's adjustment is made over all pairs of interfaces for one measure at one "
     "place (task and target, or task). Measures are not adjusted for each other."),
};

HtmlTable file_table(const Log& log) {
  HtmlTable table;
  table.caption = "Databases read, and the rows taken from them.";
  table.columns = {"file", "made by Promenade", "sessions", "trials without practice", "answers"};
  for (const LoggedFile& file : log.files) {
    table.rows.push_back({file.file, file.program_version, std::to_string(file.sessions),
                          std::to_string(file.trials), std::to_string(file.answers)});
  }
  return table;
}

HtmlTable version_table(const Log& log) {
  HtmlTable table;
  table.caption =
      "Versions of the study, the rows taken of each, and why it was changed. All rows read are "
      "counted here, also those of pilots, simulated participants and people left out.";
  table.columns = {"version", "since", "reason", "sessions", "finished", "trials without practice"};
  for (const LoggedVersion& one : log.versions) {
    const bool first = one.amended_utc.empty();
    table.rows.push_back({one.version, first ? "the beginning" : one.amended_utc,
                          first ? "" : one.reason, std::to_string(one.sessions),
                          std::to_string(one.finished), std::to_string(one.trials)});
  }
  return table;
}

HtmlTable fact_table(const Results& results) {
  const SelectionOptions& options = results.options;
  HtmlTable table;
  table.caption = "What this report rests on. The same input gives the same report, byte by byte.";
  table.columns = {"", ""};
  table.rows = {
      {"study", results.log.study + ", version " + results.log.version},
      {"hash of study, motions and texts", results.log.sha256},
      {"report made by", "Promenade " PROMENADE_VERSION},
      {"simulated sessions", options.include_simulated ? "included" : "left out"},
      {"pilot sessions", options.include_pilot ? "included" : "left out"},
      {"exclusions", options.exclude_file.empty() ? "none" : options.exclude_file},
      {"trials analysed", std::to_string(results.data.trials.size())},
      {"trials missing", std::to_string(results.data.left_out_trials)},
  };
  return table;
}

HtmlTable exclusion_table(const Selection& selection) {
  HtmlTable table;
  table.caption = "Participants excluded by the analyst.";
  table.columns = {"code", "reason"};
  for (const Exclusion& one : selection.exclusions) {
    table.rows.push_back({one.code, one.reason.empty() ? "not given" : one.reason});
  }
  return table;
}

Html text_table(const HtmlTable& table) {
  return element("div", {{"class", "wide text"}}, render(table));
}

// Nothing where the study never changed.
Html amendments(const Log& log) {
  if (log.versions.size() < 2) return {};
  return element("p", fmt::format("The study was changed {} while it ran. What is said above is "
                                  "over all versions together: judge by the reasons below whether "
                                  "they may be, and leave people out with --exclude if not.",
                                  count_of(size_of(log.versions) - 1, "time", "times"))) +
         text_table(version_table(log));
}

}  // namespace

Html method_section(const Results& results) {
  Html html = element("h2", "Method");
  for (const char* paragraph : methods) html += element("p", paragraph);
  for (const Task& task : results.data.tasks) {
    std::string sentence =
        fmt::format("Task {}: {}", task.name, count_of(size_of(task.targets), "target", "targets"));
    if (task.limit_s) sentence += fmt::format(", time limit {} s", exact_number(*task.limit_s));
    if (task.threshold_m) {
      sentence += fmt::format(", threshold D {} cm", fixed(*task.threshold_m * 100, 2));
    }
    html += element("p", sentence + ".");
  }
  return html;
}

Html provenance_section(const Results& results) {
  Html html = element("h2", "Provenance") + text_table(fact_table(results)) +
              amendments(results.log) + text_table(file_table(results.log));
  if (!results.selection.exclusions.empty()) {
    html += text_table(exclusion_table(results.selection));
  }
  html += element("p", "Queries behind every number, before people are selected as above:");
  std::string queries;
  for (const std::string& query : log_queries()) queries += query + ";\n";
  return html + element("pre", queries);
}

}  // namespace promenade::analysis
