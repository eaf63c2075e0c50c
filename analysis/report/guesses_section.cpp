// First guesses that were right: the share below the threshold without having seen the walk.
#include "analysis/item.h"
#include "analysis/report/cells.h"
#include "analysis/report/report_sections.h"

namespace promenade::analysis {
namespace {

// Of a guess that did not fail.
Interval turned(const Interval& failures) { return {1 - failures.upper, 1 - failures.lower}; }

bool is_guess(const Dataset& data, const FailureRatio& one) {
  const Task& task = item(data.tasks, one.task);
  return task.guess && task.threshold_m;
}

int right(const FailureRatio& one) { return one.trials - one.failed; }

HtmlTable guess_table(const Results& results) {
  const Dataset& data = results.data;
  HtmlTable table;
  table.caption =
      "Guesses with D below the threshold, made without seeing the walk. Trials of one person are "
      "not independent, so both intervals of “all” are too narrow.";
  table.columns = {"task",  "target", "interface",        "guesses",
                   "right", "share",  "95 % CI (Wilson)", "95 % CI (Clopper-Pearson)"};
  table.heads = 3;
  for (const FailureRatio& one : results.failures) {
    if (!is_guess(data, one)) continue;
    table.rows.push_back(
        {item(data.tasks, one.task).name, target_words(data, one.task, one.target),
         item(data.interfaces, one.interface), std::to_string(one.trials),
         std::to_string(right(one)), percent(static_cast<double>(right(one)) / one.trials),
         percent_interval(turned(one.wilson)), percent_interval(turned(one.clopper_pearson))});
    table.strong.push_back(one.target < 0);
  }
  return table;
}

Table guess_rows(const Results& results) {
  const Dataset& data = results.data;
  Table table{
      "guesses",
      "Guesses with D below the threshold, with the 95 % intervals of Wilson and of Clopper "
      "and Pearson.",
      {"task", "target", "interface", "guesses", "right", "ratio", "wilson_lower", "wilson_upper",
       "clopper_pearson_lower", "clopper_pearson_upper"},
      {}};
  for (const FailureRatio& one : results.failures) {
    if (!is_guess(data, one)) continue;
    const Interval wilson = turned(one.wilson);
    const Interval exact = turned(one.clopper_pearson);
    table.rows.push_back({cell(item(data.tasks, one.task).name),
                          target_name(data, one.task, one.target),
                          cell(item(data.interfaces, one.interface)), cell(one.trials),
                          cell(right(one)), cell(static_cast<double>(right(one)) / one.trials),
                          lower(wilson), upper(wilson), lower(exact), upper(exact)});
  }
  return table;
}

}  // namespace

Section guesses_section(const Results& results) {
  Section section;
  section.tables = {guess_rows(results)};
  if (section.tables[0].rows.empty()) return {};
  section.title = "Right by guess";
  section.html = wide(guess_table(results));
  section.json["guesses"] = json_rows(section.tables[0]);
  return section;
}

}  // namespace promenade::analysis
