// Who failed: shares with intervals, the test per participant, and target by target.
#include <fmt/format.h>

#include <algorithm>

#include "analysis/format.h"
#include "analysis/item.h"
#include "analysis/report/cells.h"
#include "analysis/report/comparison_table.h"
#include "analysis/report/report_sections.h"
#include "analysis/report/sentences.h"

namespace promenade::analysis {
namespace {

// How a difference of two shares reads.
const Measure& share_measure() {
  static const Measure share = {"failed", "share of trials failed", "", "%", 100, 0};
  return share;
}

HtmlTable ratio_table(const Results& results, int task) {
  const Dataset& data = results.data;
  HtmlTable table;
  table.caption =
      of_task(data, task) +
      "Failures: trials that ended at the time limit, or by Done with D above the threshold. "
      "Trials of one person are not independent, so both intervals of “all” are too narrow.";
  table.columns = {"target",
                   "interface",
                   "trials",
                   "failed",
                   "of these at the limit",
                   "share",
                   "95 % CI (Wilson)",
                   "95 % CI (Clopper-Pearson)"};
  table.heads = 2;
  for (const FailureRatio& one : results.failures) {
    if (one.task != task) continue;
    table.rows.push_back({target_words(data, task, one.target),
                          item(data.interfaces, one.interface), std::to_string(one.trials),
                          std::to_string(one.failed), std::to_string(one.timeouts),
                          percent(static_cast<double>(one.failed) / one.trials),
                          percent_interval(one.wilson), percent_interval(one.clopper_pearson)});
    table.strong.push_back(one.target < 0);
  }
  return table;
}

HtmlTable share_table(const Results& results, int task) {
  const Dataset& data = results.data;
  HtmlTable table;
  table.caption =
      of_task(data, task) +
      "Share of failures of each participant, by the signed-rank test: the main result on "
      "failures. Bold: adjusted p < .05.";
  table.columns = {"a − b"};
  table.columns.insert(table.columns.end(), test_columns().begin(), test_columns().end());
  for (const Comparison& one : results.failure_tests.shares) {
    if (one.task != task || !is_possible(results, data.measure("time_s"), one)) continue;
    std::vector<std::string> row = {pair_name(data, one.a, one.b)};
    for (std::string& cell : test_cells(share_measure(), one)) row.push_back(std::move(cell));
    table.rows.push_back(std::move(row));
    table.strong.push_back(is_significant(one));
  }
  return table;
}

HtmlTable pair_table(const Results& results, int task) {
  const Dataset& data = results.data;
  HtmlTable table;
  table.caption = of_task(data, task) +
                  "Target by target: who failed with just one of two interfaces, by McNemar’s "
                  "exact test. Holm’s family: the pairs of one target.";
  table.columns = {"target",           "a, b",        "n",
                   "failed with both", "with a only", "with b only",
                   "with neither",     "exact p",     "Holm p"};
  table.heads = 2;
  for (const FailurePair& one : results.failure_tests.pairs) {
    if (one.task != task || one.both + one.only_a + one.only_b == 0) continue;
    table.rows.push_back({target_words(data, task, one.target),
                          item(data.interfaces, one.a) + ", " + item(data.interfaces, one.b),
                          std::to_string(one.n()), std::to_string(one.both),
                          std::to_string(one.only_a), std::to_string(one.only_b),
                          std::to_string(one.neither), p_cell(one.test.p_exact),
                          p_cell(one.p_holm)});
    table.strong.push_back(one.p_holm < significance);
  }
  return table;
}

HtmlTable omnibus_table(const Results& results, int task) {
  const Dataset& data = results.data;
  HtmlTable table;
  table.caption = of_task(data, task) +
                  "Target by target: all interfaces at once by Cochran’s Q, of those who tried the "
                  "target with each of them.";
  table.columns = {"target", "interfaces", "n", "failed", "Q", "df", "χ² p", "exact p"};
  for (const FailureOmnibus& one : results.failure_tests.omnibus) {
    const CochranTest& test = one.test;
    if (one.task != task || !test.q) continue;
    std::string failed;
    for (const int total : test.column_totals) {
      failed += (failed.empty() ? "" : ", ") + std::to_string(total);
    }
    table.rows.push_back({target_words(data, task, one.target), std::to_string(test.k),
                          std::to_string(test.n), failed, fixed(*test.q, 2),
                          std::to_string(test.k - 1), p_cell(test.p), p_cell(test.p_exact)});
    table.strong.push_back(test.p_exact.value_or(*test.p) < significance);
  }
  return table;
}

bool any_failed(const Results& results, int task) {
  return std::any_of(
      results.failures.begin(), results.failures.end(),
      [task](const FailureRatio& one) { return one.task == task && one.failed > 0; });
}

Html tests_of(const Results& results, int task) {
  if (results.data.interfaces.size() < 2 || !can_fail(results.data, task)) return {};
  if (!any_failed(results, task)) {
    return element("p",
                   of_task(results.data, task) + "Nobody failed, so there is nothing to compare.");
  }
  return wide(share_table(results, task)) + folded(omnibus_table(results, task)) +
         folded(pair_table(results, task));
}

Html failures_in(const Results& results, int task) {
  if (!can_fail(results.data, task)) {
    return element("p", of_task(results.data, task) +
                            "No trial failed, and no time limit or threshold held for all of "
                            "them: there are no shares of failures.");
  }
  return wide(ratio_table(results, task)) + tests_of(results, task);
}

Table share_rows(const Results& results) {
  const Dataset& data = results.data;
  Table table{
      "failure_shares",
      "Pairs of interfaces by the share of trials that each participant failed (differences "
      "are a − b), by the signed-rank test.",
      {"task", "a", "b", "n", "n_missing", "n_zero", "n_tied", "W_plus", "W_minus", "p_exact_two",
       "p_asym_two", "p_holm", "holm_family", "rank_biserial", "rank_biserial_ci_lower",
       "rank_biserial_ci_upper", "hl", "hl_ci_lower", "hl_ci_upper"},
      {}};
  for (const Comparison& one : results.failure_tests.shares) {
    const SignedRankTest& test = one.test;
    const bool any = test.n > 0;
    const auto ci = interval_of(one.hl_ci);
    table.rows.push_back({cell(item(data.tasks, one.task).name), cell(item(data.interfaces, one.a)),
                          cell(item(data.interfaces, one.b)), cell(test.n), cell(one.missing),
                          cell(test.n_zero), cell(test.n_tied), cell(test.w_plus),
                          cell(test.w_minus), any && test.exact ? cell(test.exact->two) : Cell(),
                          test.normal ? cell(test.normal->two) : Cell(), cell(one.p_holm),
                          cell(one.family), cell(test.rank_biserial), lower(one.rank_biserial_ci),
                          upper(one.rank_biserial_ci), cell(one.hl), lower(ci), upper(ci)});
  }
  return table;
}

Table pair_rows(const Results& results) {
  const Dataset& data = results.data;
  Table table{"failure_pairs",
              "Who failed a target with which of two interfaces, by McNemar's test.",
              {"task", "target", "a", "b", "n", "both", "only_a", "only_b", "neither", "p_exact",
               "p_mid", "p_holm", "holm_family"},
              {}};
  for (const FailurePair& one : results.failure_tests.pairs) {
    table.rows.push_back(
        {cell(item(data.tasks, one.task).name), target_name(data, one.task, one.target),
         cell(item(data.interfaces, one.a)), cell(item(data.interfaces, one.b)), cell(one.n()),
         cell(one.both), cell(one.only_a), cell(one.only_b), cell(one.neither),
         cell(one.test.p_exact), cell(one.test.p_mid), cell(one.p_holm), cell(one.family)});
  }
  return table;
}

Table omnibus_rows(const Results& results) {
  const Dataset& data = results.data;
  Table table{"failure_omnibus",
              "Failures of a target with each interface, by Cochran's Q.",
              {"task", "target", "interface", "failed", "n", "k", "q", "df", "p_chi2", "p_exact"},
              {}};
  for (const FailureOmnibus& one : results.failure_tests.omnibus) {
    const CochranTest& test = one.test;
    for (int i = 0; i < test.k; ++i) {
      table.rows.push_back(
          {cell(item(data.tasks, one.task).name), target_name(data, one.task, one.target),
           cell(item(data.interfaces, item(one.interfaces, i))), cell(item(test.column_totals, i)),
           cell(test.n), cell(test.k), cell(test.q), cell(test.k - 1), cell(test.p),
           test.q ? cell(test.p_exact) : Cell()});
    }
  }
  return table;
}

}  // namespace

Section failures_section(const Results& results) {
  if (results.data.trials.empty()) return {};
  Section section;
  section.title = "Failures";
  for (int task = 0; task < size_of(results.data.tasks); ++task) {
    section.html += failures_in(results, task);
  }
  if (!results.failures.empty()) {
    section.html += note(
        "Who tried a target more than once with an interface counts with the first trial in the "
        "tests of one target, and with all of them in the share.");
  }
  section.tables = {share_rows(results), pair_rows(results), omnibus_rows(results)};
  for (const Table& table : section.tables) section.json[table.name] = json_rows(table);
  return section;
}

}  // namespace promenade::analysis
