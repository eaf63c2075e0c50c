// Each interface by itself: per participant, and target by target.
#include "analysis/format.h"
#include "analysis/item.h"
#include "analysis/report/cells.h"
#include "analysis/report/report_sections.h"

namespace promenade::analysis {
namespace {

HtmlTable summary_table(const Results& results, int task) {
  const Dataset& data = results.data;
  HtmlTable table;
  table.caption =
      of_task(data, task) +
      "Each interface by itself: one value per participant, the mean over targets. Measures of "
      "the process stand in tables/summaries.csv.";
  table.columns = {"measure", "interface", "n", "mean", "SD", "median", "95 % CI of the median"};
  table.heads = 2;
  for (const Summary& one : results.summaries) {
    const Measure& measure = item(data.measures, one.measure);
    if (one.task != task || measure.kind == MeasureKind::process) continue;
    table.rows.push_back({measure.label, item(data.interfaces, one.interface),
                          std::to_string(one.n), with_unit(measure, *one.mean),
                          one.sd ? shown(measure, *one.sd) : dash, with_unit(measure, *one.median),
                          one.median_ci ? shown_interval(measure, *one.median_ci) : dash});
  }
  return table;
}

HtmlTable target_table(const Results& results, int task) {
  const Dataset& data = results.data;
  HtmlTable table;
  table.caption = of_task(data, task) +
                  "Each target with each interface, one value per participant. Measures of the "
                  "process stand in tables/descriptives.csv.";
  table.columns = {"measure", "target", "interface", "n", "mean", "SD", "median", "least", "most"};
  table.heads = 3;
  for (const TargetSummary& one : results.target_summaries) {
    const Measure& measure = item(data.measures, one.measure);
    if (one.task != task || measure.kind == MeasureKind::process) continue;
    table.rows.push_back({measure.label, target_words(data, task, one.target),
                          item(data.interfaces, one.interface), std::to_string(one.n),
                          with_unit(measure, one.mean), one.sd ? shown(measure, *one.sd) : dash,
                          with_unit(measure, one.median), shown(measure, one.least),
                          shown(measure, one.most)});
  }
  return table;
}

Table descriptives(const Results& results) {
  const Dataset& data = results.data;
  Table table{
      "descriptives",
      "Each target with each interface; one value per participant.",
      {"measure", "unit", "task", "target", "interface", "n", "mean", "sd", "median", "min", "max"},
      {}};
  for (const TargetSummary& one : results.target_summaries) {
    const Measure& measure = item(data.measures, one.measure);
    table.rows.push_back({cell(measure.name), cell(measure.unit),
                          cell(item(data.tasks, one.task).name),
                          target_name(data, one.task, one.target),
                          cell(item(data.interfaces, one.interface)), cell(one.n), cell(one.mean),
                          cell(one.sd), cell(one.median), cell(one.least), cell(one.most)});
  }
  return table;
}

}  // namespace

Section descriptives_section(const Results& results) {
  if (results.data.trials.empty()) return {};
  Section section;
  section.title = "Each interface by itself";
  for (int task = 0; task < size_of(results.data.tasks); ++task) {
    section.html += wide(summary_table(results, task)) + folded(target_table(results, task));
  }
  section.tables = {descriptives(results)};
  section.json["descriptives"] = json_rows(section.tables[0]);
  return section;
}

}  // namespace promenade::analysis
