// Primary results with other trials and people, side by side.
#include "analysis/format.h"
#include "analysis/item.h"
#include "analysis/report/cells.h"
#include "analysis/report/report_sections.h"

namespace promenade::analysis {
namespace {

std::string answer(const std::optional<bool>& same) {
  if (!same) return dash;
  return *same ? "yes" : "no";
}

std::string pair_of(const Dataset& data, const SensitivityResult& one) {
  return item(data.interfaces, one.a) + " − " + item(data.interfaces, one.b);
}

Table result_table(const Results& results) {
  const Dataset& data = results.data;
  Table table{"sensitivity",
              "Every primary result (differences are a − b) with other trials and people.",
              {"analysis", "people", "trials", "measure", "unit", "task", "a", "b", "n", "hl",
               "hl_ci_lower", "hl_ci_upper", "p", "p_holm", "same_conclusion"},
              {}};
  for (const SensitivityVariant& variant : results.sensitivity.variants) {
    for (const SensitivityResult& one : variant.results) {
      const Measure& measure = item(data.measures, one.measure);
      table.rows.push_back(
          {cell(variant.name), cell(variant.people), cell(variant.trials), cell(measure.name),
           cell(measure.unit), cell(item(data.tasks, one.task).name),
           cell(item(data.interfaces, one.a)), cell(item(data.interfaces, one.b)), cell(one.n),
           cell(one.hl), lower(one.hl_ci), upper(one.hl_ci), cell(one.p), cell(one.p_holm),
           one.same_conclusion ? cell(*one.same_conclusion) : Cell()});
    }
  }
  return table;
}

// Rows of one result stand together: as reported, then each other choice.
HtmlTable shown_table(const Results& results) {
  const Dataset& data = results.data;
  const auto& variants = results.sensitivity.variants;
  HtmlTable table;
  table.caption =
      "One value per participant; differences by Hodges-Lehmann with 95 % interval, exact p, Holm "
      "over the pairs of one measure. The same conclusion: significant at .05 with the same sign, "
      "or in both not significant. Bold: it changes.";
  table.columns = {"measure", "a − b",  "analysis",       "n", "difference [95 % CI]",
                   "p",       "Holm p", "same conclusion"};
  table.heads = 3;
  for (int i = 0; i < results.sensitivity.compared; ++i) {
    for (const SensitivityVariant& variant : variants) {
      const SensitivityResult& one = item(variant.results, i);
      const bool first = variant.kind == SensitivityKind::all;
      table.rows.push_back({measure_in_task(data, one.measure, one.task), pair_of(data, one),
                            variant.name, std::to_string(one.n),
                            estimate_cell(item(data.measures, one.measure), one.hl, one.hl_ci),
                            p_cell(one.p), p_cell(one.p_holm),
                            first ? "" : answer(one.same_conclusion)});
      table.strong.push_back(!first && !one.same_conclusion.value_or(true));
    }
  }
  return table;
}

Html sentences(const Results& results) {
  if (results.sensitivity.compared == 0) {
    return element("p", "There is no pair of interfaces whose comparison could change.");
  }
  if (results.sensitivity.sentences.empty()) {
    return element("p",
                   "No trial is flagged, nobody is excluded, and there is one version of the "
                   "study: nothing could be left out to see whether the conclusions hold.");
  }
  Html html;
  for (const std::string& one : results.sensitivity.sentences) html += element("p", one);
  return html;
}

}  // namespace

Section sensitivity_section(const Results& results) {
  Section section;
  section.title = "Sensitivity";
  section.html = sentences(results);
  const Table table = result_table(results);
  section.json["sensitivity"] = {{"sentences", results.sensitivity.sentences},
                                 {"results", json_rows(table)}};
  if (!table.rows.empty()) section.tables = {table};
  if (results.sensitivity.variants.size() > 1) section.html += wide(shown_table(results));
  return section;
}

}  // namespace promenade::analysis
