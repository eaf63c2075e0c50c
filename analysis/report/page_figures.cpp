// Figures, and the tables that a paper would print.
#include <fmt/format.h>

#include <cmath>

#include "analysis/format.h"
#include "analysis/item.h"
#include "analysis/report/page_parts.h"
#include "analysis/report/sentences.h"

namespace promenade::analysis {
namespace {

constexpr const char* dash = "–";

std::string p_cell(const std::optional<double>& p) {
  if (!p) return dash;
  const std::string words = p_text(*p);
  return words[0] == '=' ? words.substr(2) : words;
}

// W can end in one half.
std::string rank_sum(double w) { return fixed(w, w == std::floor(w) ? 0 : 1); }

std::string difference(const Measure& measure, const Comparison& one) {
  if (!one.hl) return dash;
  std::string estimate = with_unit(measure, *one.hl);
  if (!one.hl_ci) return estimate;
  return estimate + " [" + shown(measure, one.hl_ci->interval.lower) + ", " +
         shown(measure, one.hl_ci->interval.upper) + "]";
}

const std::vector<std::string>& test_columns() {
  static const std::vector<std::string> columns = {
      "n", "zeros", "W+", "W−", "exact p", "Holm p", "normal p", "r", "a − b [95 % CI]"};
  return columns;
}

// One difference tests nothing; a handful have an exact p, but no normal one.
std::vector<std::string> test_cells(const Dataset& data, const Comparison& one) {
  const SignedRankTest& test = one.test;
  const int differing = test.n - test.n_zero;
  const bool testable = test.n > 1;
  return {std::to_string(test.n),
          std::to_string(test.n_zero),
          rank_sum(test.w_plus),
          rank_sum(test.w_minus),
          testable && test.exact ? p_cell(test.exact->two) : dash,
          testable ? p_cell(one.p_holm) : dash,
          differing >= 6 ? p_cell(test.normal->two) : dash,
          testable && test.rank_biserial ? fixed(*test.rank_biserial, 2) : dash,
          difference(item(data.measures, one.measure), one)};
}

std::string pair_name(const Dataset& data, const Comparison& one) {
  return item(data.interfaces, one.a) + " − " + item(data.interfaces, one.b);
}

bool is_in_spotlight(const Results& results, const Comparison& one) {
  const std::string& name = item(results.data.measures, one.measure).name;
  return name == "d_final" || name == "time_s" || name == "d_first" || name == "d_best";
}

HtmlTable comparison_table(const Results& results, int task, Pooling pooling, std::string caption) {
  const Dataset& data = results.data;
  HtmlTable table;
  table.caption = std::move(caption);
  const bool by_target = pooling == Pooling::none;
  table.columns = {"measure"};
  if (by_target) table.columns.emplace_back("target");
  table.columns.emplace_back("a − b");
  table.heads = size_of(table.columns);
  table.columns.insert(table.columns.end(), test_columns().begin(), test_columns().end());
  for (const Comparison& one : results.comparisons) {
    if (one.task != task || one.pooling != pooling) continue;
    if (by_target && !is_in_spotlight(results, one)) continue;
    std::vector<std::string> row = {item(data.measures, one.measure).label};
    if (by_target) row.push_back(item(item(data.tasks, task).targets, one.target));
    row.push_back(pair_name(data, one));
    for (std::string& cell : test_cells(data, one)) row.push_back(std::move(cell));
    table.rows.push_back(std::move(row));
    table.strong.push_back(is_significant(one));
  }
  return table;
}

Html wide(const HtmlTable& table) {
  return table.rows.empty() ? Html{} : element("div", {{"class", "wide"}}, render(table));
}

HtmlTable summary_table(const Results& results, int task) {
  const Dataset& data = results.data;
  HtmlTable table;
  table.caption = "Each interface by itself: one value per participant, the mean over targets.";
  table.columns = {"measure", "interface", "n", "mean", "SD", "median", "95 % CI of the median"};
  table.heads = 2;
  for (const Summary& one : results.summaries) {
    if (one.task != task) continue;
    const Measure& measure = item(data.measures, one.measure);
    table.rows.push_back({measure.label, item(data.interfaces, one.interface),
                          std::to_string(one.n), with_unit(measure, *one.mean),
                          one.sd ? shown(measure, *one.sd) : dash, with_unit(measure, *one.median),
                          one.median_ci ? shown_interval(measure, *one.median_ci) : dash});
  }
  return table;
}

HtmlTable failure_table(const Results& results, int task) {
  const Dataset& data = results.data;
  HtmlTable table;
  table.caption =
      "Failures: trials that ended at the time limit, or by Done with D above the threshold, with "
      "the 95 % Wilson interval of their share. Trials of one person are not independent.";
  table.columns = {"target", "interface", "trials", "failed", "of these at the limit",
                   "share",  "95 % CI"};
  table.heads = 2;
  for (const FailureRatio& one : results.failures) {
    if (one.task != task) continue;
    table.rows.push_back(
        {one.target < 0 ? "all" : item(item(data.tasks, task).targets, one.target),
         item(data.interfaces, one.interface), std::to_string(one.trials),
         std::to_string(one.failed), std::to_string(one.timeouts),
         fixed(100.0 * one.failed / one.trials, 0) + " %",
         fixed(100 * one.wilson.lower, 0) + " to " + fixed(100 * one.wilson.upper, 0) + " %"});
    table.strong.push_back(one.target < 0);
  }
  return table;
}

Html task_tables(const Results& results, int task) {
  const bool several = results.data.tasks.size() > 1;
  const std::string suffix = several ? ": " + item(results.data.tasks, task).name : "";
  Html html = element("h2", "Interfaces compared" + suffix);
  if (results.data.interfaces.size() < 2) {
    html += element("p", "Only one interface was used, so there is no pair to compare.");
  }
  html += wide(comparison_table(
      results, task, Pooling::participants,
      "Signed-rank tests with one value per participant (the mean over targets): the main "
      "result. Bold: adjusted p < .05."));
  html += wide(summary_table(results, task));
  html += element("h2", "Failures" + suffix) + wide(failure_table(results, task));
  if (results.data.interfaces.size() < 2) return html;
  html += element("h2", "Target by target" + suffix);
  html += wide(comparison_table(results, task, Pooling::none,
                                "Signed-rank tests for each target by itself, D and time; the "
                                "other measures stand in tables/comparisons.csv."));
  html += element("h2", "All trials pooled" + suffix);
  html += wide(comparison_table(
      results, task, Pooling::trials,
      "As papers in this field print it: each participant and target counts as one pair. Pairs "
      "of the same person are not independent, so these p are too small; shown for comparison "
      "only."));
  return html;
}

}  // namespace

Html figure_section(const std::vector<DrawnFigure>& figures) {
  Html html;
  int number = 0;
  for (const DrawnFigure& drawn : figures) {
    const std::string source = "data:image/svg+xml;base64," + base64(drawn.svg);
    html += element(
        "figure",
        empty_element("img", {{"src", source}, {"alt", drawn.figure.caption}}) +
            element("figcaption", fmt::format("Figure {}. {}", ++number, drawn.figure.caption)));
  }
  return element("h2", "Figures") + element("div", {{"class", "figures"}}, html);
}

Html table_sections(const Results& results) {
  Html html;
  for (int task = 0; task < size_of(results.data.tasks); ++task) html += task_tables(results, task);
  return html;
}

}  // namespace promenade::analysis
