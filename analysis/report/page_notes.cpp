// What it was computed from.
#include <fmt/format.h>

#include "analysis/format.h"
#include "analysis/item.h"
#include "analysis/report/cells.h"
#include "analysis/report/page_parts.h"
#include "analysis/report/tables.h"

namespace promenade::analysis {
namespace {

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
      {"rated by", options.rated_by.empty() ? "nobody else" : listed(options.rated_by)},
      {"trials analysed", std::to_string(results.data.trials.size())},
      {"trials missing", std::to_string(results.data.left_out_trials)},
  };
  return table;
}

// Nothing where the study never changed.
Html amendments(const Log& log) {
  if (log.versions.size() < 2) return {};
  return element("p", fmt::format("The study was changed {} while it ran. What is said above is "
                                  "over all versions together: judge by the reasons below whether "
                                  "they may be, and leave people out with --exclude if not.",
                                  count_of(size_of(log.versions) - 1, "time", "times"))) +
         wide_words(version_table(log));
}

}  // namespace

Html provenance_section(const Results& results) {
  Html html = element("h2", {{"id", "provenance"}}, text("Provenance")) +
              wide_words(fact_table(results)) + amendments(results.log) +
              wide_words(file_table(results.log));
  html += element("p", "Queries behind every number, before people are selected as above:");
  std::string queries;
  for (const std::string& query : log_queries()) queries += query + ";\n";
  return html + element("pre", queries);
}

}  // namespace promenade::analysis
