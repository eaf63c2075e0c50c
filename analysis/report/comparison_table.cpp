#include "analysis/report/comparison_table.h"

#include <fmt/format.h>

#include <algorithm>

#include "analysis/format.h"
#include "analysis/item.h"
#include "analysis/report/cells.h"
#include "analysis/report/sentences.h"

namespace promenade::analysis {
namespace {

// One difference tests nothing.
bool is_testable(const Comparison& one) { return one.test.n > 1; }

std::string exact_cell(const Comparison& one) {
  if (!is_testable(one)) return dash;
  if (one.test.exact) return p_cell(one.test.exact->two);
  return one.p ? p_cell(one.p) + " (normal)" : dash;
}

std::string rank_biserial_cell(const Comparison& one) {
  if (!is_testable(one) || !one.test.rank_biserial) return dash;
  const std::string r = fixed(*one.test.rank_biserial, 2);
  if (!one.rank_biserial_ci) return r;
  return r + " [" + fixed(one.rank_biserial_ci->lower, 2) + ", " +
         fixed(one.rank_biserial_ci->upper, 2) + "]";
}

bool is_in_spotlight(const Measure& measure) {
  const std::string& name = measure.name;
  return name == "d_final" || name == "time_s" || name == "d_first" || name == "d_best";
}

// All trials begin from the same walk, unless they begin from a guess.
bool is_same_start(const Measure& measure, const Comparison& one) {
  return measure.name == "d_first" && one.test.n == one.test.n_zero;
}

}  // namespace

const std::vector<std::string>& test_columns() {
  static const std::vector<std::string> columns = {
      "n",       "zeros",  "tied",     "W+",          "W−",
      "exact p", "Holm p", "normal p", "r [95 % CI]", "a − b [95 % CI]"};
  return columns;
}

// A handful of differences have an exact p, but no normal one.
std::vector<std::string> test_cells(const Measure& measure, const Comparison& one) {
  const SignedRankTest& test = one.test;
  const int differing = test.n - test.n_zero;
  return {std::to_string(test.n),
          std::to_string(test.n_zero),
          std::to_string(test.n_tied),
          rank_sum(test.w_plus),
          rank_sum(test.w_minus),
          exact_cell(one),
          is_testable(one) ? p_cell(one.p_holm) : dash,
          differing >= 6 ? p_cell(test.normal->two) : dash,
          rank_biserial_cell(one),
          estimate_cell(measure, one.hl, interval_of(one.hl_ci))};
}

bool is_possible(const Results& results, int measure, const Comparison& one) {
  if (one.test.n > 0) return true;
  int used = 0;
  for (const Summary* summary : results.summaries_of(measure, one.task)) {
    used += summary->interface == one.a || summary->interface == one.b ? 1 : 0;
  }
  return used == 2;
}

HtmlTable comparison_table(const Results& results, int task, Pooling pooling, std::string caption,
                           bool process) {
  const Dataset& data = results.data;
  HtmlTable table;
  table.caption = of_task(data, task) + std::move(caption);
  const bool by_target = pooling == Pooling::none;
  table.columns = {"measure"};
  if (by_target) table.columns.emplace_back("target");
  table.columns.emplace_back("a − b");
  table.heads = size_of(table.columns);
  table.columns.insert(table.columns.end(), test_columns().begin(), test_columns().end());
  for (const Comparison& one : results.comparisons) {
    if (one.task != task || one.pooling != pooling) continue;
    const Measure& measure = item(data.measures, one.measure);
    if ((measure.kind == MeasureKind::process) != process) continue;
    if (!is_possible(results, one.measure, one)) continue;
    if (by_target && !is_in_spotlight(measure)) continue;
    if (is_same_start(measure, one)) continue;
    std::vector<std::string> row = {measure.label};
    if (by_target) row.push_back(target_words(data, task, one.target));
    row.push_back(pair_name(data, one.a, one.b));
    for (std::string& cell : test_cells(measure, one)) row.push_back(std::move(cell));
    table.rows.push_back(std::move(row));
    table.strong.push_back(is_significant(one));
  }
  return table;
}

Html family_note(const Results& results, Pooling pooling) {
  const auto k = size_of(results.data.interfaces);
  const int pairs = k * (k - 1) / 2;
  const std::string tests =
      pairs == 1 ? "that is one test" : fmt::format("that is up to {} tests", pairs);
  Html html = note("Holm’s family: all pairs of interfaces for one measure at one place; here " +
                   tests + ". Measures, tasks and targets are not adjusted for each other.");
  const bool approximate = std::any_of(
      results.comparisons.begin(), results.comparisons.end(),
      [pooling](const Comparison& one) { return one.pooling == pooling && is_approximate(one); });
  if (!approximate) return html;
  return html + note(pooling == Pooling::trials
                         ? fmt::format("“(normal)” marks a p by the normal approximation without "
                                       "continuity correction in place of the exact one: pooled "
                                       "tests are exact up to {} differing pairs, since beyond "
                                       "the two hardly differ and the count takes long.",
                                       pooled_limit)
                         : fmt::format("“(normal)” marks a p by the normal approximation without "
                                       "continuity correction in place of the exact one, which is "
                                       "counted up to {} differing pairs: beyond, its "
                                       "probabilities leave the range of the machine’s numbers.",
                                       sign_flips_limit));
}

}  // namespace promenade::analysis
