// Times: the restricted mean of each participant first, then tests for censored times.
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

std::string seconds(const std::optional<double>& value) {
  return value ? fixed(*value, 1) : "not reached";
}

// The main result again, where a reader of times looks for it.
HtmlTable mean_table(const Results& results, int task) {
  const Dataset& data = results.data;
  const int measure = data.measure("time_s");
  HtmlTable table;
  table.caption = of_task(data, task) + "First: the mean time of each participant" +
                  (item(data.tasks, task).limit_s ? ", restricted to the limit," : "") +
                  " by the exact signed-rank test. Bold: adjusted p < .05.";
  table.columns = {"a − b"};
  table.columns.insert(table.columns.end(), test_columns().begin(), test_columns().end());
  for (const Comparison* one : results.pairs(measure, task)) {
    if (!is_possible(results, measure, *one)) continue;
    std::vector<std::string> row = {pair_name(data, one->a, one->b)};
    for (std::string& cell : test_cells(item(data.measures, measure), *one)) {
      row.push_back(std::move(cell));
    }
    table.rows.push_back(std::move(row));
    table.strong.push_back(is_significant(*one));
  }
  return table;
}

HtmlTable curve_table(const Results& results, const TaskTimes& times) {
  HtmlTable table;
  table.caption = of_task(results.data, times.task) +
                  fmt::format(
                      "{}ll trials by the method of Kaplan and Meier, in seconds. Time limit "
                      "and giving up are right-censored. The mean is restricted to {} s, {}.",
                      times.pairs.empty() ? "A" : "Beside it: a", fixed(times.horizon, 1),
                      times.to_limit ? "the limit" : "up to where every interface has trials");
  table.columns = {"interface", "trials",          "done",   "censored", "median",
                   "95 % CI",   "restricted mean", "95 % CI"};
  for (const TimeCurve& one : times.curves) {
    const auto& ci = one.median_ci;
    table.rows.push_back({item(results.data.interfaces, one.interface), std::to_string(one.trials),
                          std::to_string(one.done), std::to_string(one.trials - one.done),
                          seconds(one.survival.median),
                          ci.lower ? seconds(ci.lower) + " to " + seconds(ci.upper) : dash,
                          fixed(one.restricted.mean, 1),
                          fixed(one.restricted.interval.lower, 1) + " to " +
                              fixed(one.restricted.interval.upper, 1)});
  }
  return table;
}

HtmlTable rank_table(const Results& results, const TaskTimes& times) {
  const Dataset& data = results.data;
  HtmlTable table;
  table.caption = of_task(data, times.task) +
                  "The same trials by the log-rank test, stratified by participant. Holm’s "
                  "family: all pairs of interfaces.";
  table.columns = {"interfaces", "χ²", "df", "p", "Holm p"};
  if (times.curves.size() > 2) {
    table.rows.push_back({"all", number_cell(times.test.chi2, 2), std::to_string(times.test.df),
                          p_cell(times.test.p), dash});
    table.strong.push_back(times.test.p.value_or(1) < significance);
  }
  for (const TimePair& one : times.pairs) {
    table.rows.push_back({item(data.interfaces, one.a) + ", " + item(data.interfaces, one.b),
                          number_cell(one.test.chi2, 2), std::to_string(one.test.df),
                          p_cell(one.test.p), p_cell(one.p_holm)});
    table.strong.push_back(one.p_holm.value_or(1) < significance);
  }
  return table;
}

// A match that starts from a guess that was right already is a success that took no time.
Html won_at_once(const Results& results, int task) {
  const Dataset& data = results.data;
  const int time = data.measure("time_s");
  std::vector<int> won(data.interfaces.size(), 0), all(data.interfaces.size(), 0);
  for (const Trial& trial : data.trials) {
    if (trial.task != task) continue;
    ++item(all, trial.interface);
    const bool at_once = trial.outcome == "success" && item(trial.values, time) == 0.0;
    item(won, trial.interface) += at_once ? 1 : 0;
  }
  std::string counts;
  for (int i = 0; i < size_of(won); ++i) {
    if (item(all, i) == 0) continue;
    counts += fmt::format("{}{} {} of {}", counts.empty() ? "" : ", ", item(data.interfaces, i),
                          item(won, i), item(all, i));
  }
  if (std::all_of(won.begin(), won.end(), [](int n) { return n == 0; })) return {};
  return note(of_task(data, task) + "Won before they began, and so successes with a time of 0 s: " +
              counts + ". Times of this task tell how good the start was, too.");
}

Table curve_rows(const Results& results) {
  const Dataset& data = results.data;
  Table table{"times",
              "Times of all trials with an interface, failures censored (Kaplan-Meier).",
              {"task", "interface", "trials", "done", "censored", "median_s", "median_ci_lower",
               "median_ci_upper", "horizon_s", "restricted_mean_s", "restricted_mean_se",
               "restricted_mean_ci_lower", "restricted_mean_ci_upper"},
              {}};
  for (const TaskTimes& times : results.times) {
    for (const TimeCurve& one : times.curves) {
      table.rows.push_back({cell(item(data.tasks, times.task).name),
                            cell(item(data.interfaces, one.interface)), cell(one.trials),
                            cell(one.done), cell(one.trials - one.done), cell(one.survival.median),
                            cell(one.median_ci.lower), cell(one.median_ci.upper),
                            cell(times.horizon), cell(one.restricted.mean), cell(one.restricted.se),
                            lower(one.restricted.interval), upper(one.restricted.interval)});
    }
  }
  return table;
}

std::vector<Cell> rank_row(const std::string& task, const Cell& a, const Cell& b,
                           const LogRankTest& test) {
  return {cell(task), a, b, cell(test.chi2), cell(test.df), cell(test.p)};
}

Table rank_rows(const Results& results) {
  const Dataset& data = results.data;
  Table table{
      "log_rank",
      "Times by the log-rank test stratified by participant; a and b empty: all interfaces.",
      {"task", "a", "b", "chi2", "df", "p", "p_holm", "holm_family"},
      {}};
  for (const TaskTimes& times : results.times) {
    const std::string& task = item(data.tasks, times.task).name;
    if (times.curves.size() > 2) {
      table.rows.push_back(rank_row(task, {}, {}, times.test));
      table.rows.back().resize(table.columns.size());
    }
    for (const TimePair& one : times.pairs) {
      std::vector<Cell> row = rank_row(task, cell(item(data.interfaces, one.a)),
                                       cell(item(data.interfaces, one.b)), one.test);
      row.push_back(cell(one.p_holm));
      row.push_back(cell(one.family));
      table.rows.push_back(std::move(row));
    }
  }
  return table;
}

}  // namespace

Section times_section(const Results& results) {
  if (results.times.empty()) return {};
  Section section;
  section.title = "Times";
  for (const TaskTimes& times : results.times) {
    section.html += wide(mean_table(results, times.task)) + won_at_once(results, times.task) +
                    wide(curve_table(results, times)) + wide(rank_table(results, times));
  }
  section.html += note(
      "Trials of one person are not independent: the curves and their intervals take them for it, "
      "and the log-rank test compares the trials within each person only. Somebody who gives up "
      "is not like somebody who goes on, which censoring supposes. So these are a look from "
      "another side; the first test is the result. “Not reached”: fewer than half were done. A "
      "dash: no time to compare, or too little to say.");
  section.tables = {curve_rows(results), rank_rows(results)};
  for (const Table& table : section.tables) section.json[table.name] = json_rows(table);
  return section;
}

}  // namespace promenade::analysis
