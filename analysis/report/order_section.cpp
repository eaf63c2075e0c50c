// Order effects: turns, learning, carry-over, and the balance of the orders.
#include <fmt/format.h>

#include "analysis/format.h"
#include "analysis/item.h"
#include "analysis/report/cells.h"
#include "analysis/report/report_sections.h"

namespace promenade::analysis {
namespace {

std::string task_of(const Dataset& data, int task) { return item(data.tasks, task).name; }

Table turn_table(const Results& results) {
  const Dataset& data = results.data;
  Table table{"order_turns",
              "Values by the turn of the interface, whatever it was; one per participant.",
              {"measure", "unit", "task", "turn", "n", "mean", "sd", "mean_ci_lower",
               "mean_ci_upper", "median"},
              {}};
  for (const TurnSummary& one : results.order.turns) {
    const Measure& measure = item(data.measures, one.measure);
    table.rows.push_back({cell(measure.name), cell(measure.unit), cell(task_of(data, one.task)),
                          cell(one.turn), cell(one.moments.n), cell(one.moments.mean),
                          cell(one.moments.sd), lower(one.moments.mean_ci),
                          upper(one.moments.mean_ci), cell(one.median)});
  }
  return table;
}

Table learning_table(const Results& results) {
  const Dataset& data = results.data;
  Table table{"order_learning",
              "Change per turn, by participant, tested against zero.",
              {"measure", "unit", "task", "n", "n_zero", "hl", "hl_ci_lower", "hl_ci_upper",
               "W_plus", "W_minus", "p", "positive", "negative", "p_sign"},
              {}};
  for (const Learning& one : results.order.learning) {
    const Measure& measure = item(data.measures, one.measure);
    table.rows.push_back({cell(measure.name), cell(measure.unit), cell(task_of(data, one.task)),
                          cell(one.test.n), cell(one.test.n_zero), cell(one.hl),
                          lower(interval_of(one.hl_ci)), upper(interval_of(one.hl_ci)),
                          Cell(one.test.w_plus), Cell(one.test.w_minus), cell(one.p),
                          cell(one.test.n_positive), cell(one.test.n_negative),
                          one.sign.n > 0 ? Cell(one.sign.two) : Cell()});
  }
  return table;
}

Table carry_over_table(const Results& results) {
  const Dataset& data = results.data;
  Table table{"order_carry_over",
              "Values of each interface by the one before it; one per participant.",
              {"measure", "unit", "task", "interface", "previous", "n", "mean", "sd",
               "mean_ci_lower", "mean_ci_upper"},
              {}};
  for (const CarryOver& one : results.order.carry_over) {
    const Measure& measure = item(data.measures, one.measure);
    table.rows.push_back({cell(measure.name), cell(measure.unit), cell(task_of(data, one.task)),
                          cell(item(data.interfaces, one.interface)),
                          one.previous < 0 ? Cell() : cell(item(data.interfaces, one.previous)),
                          cell(one.moments.n), cell(one.moments.mean), cell(one.moments.sd),
                          lower(one.moments.mean_ci), upper(one.moments.mean_ci)});
  }
  return table;
}

// Long: one count in a row, of a turn or of the interface before.
Table balance_table(const Results& results) {
  const Dataset& data = results.data;
  Table table{"order_balance",
              "How many of those analysed had an interface at a turn, or after another one.",
              {"task", "interface", "turn", "previous", "people"},
              {}};
  for (const TurnCount& one : results.order.turn_counts) {
    for (int i = 0; i < size_of(one.at_turn); ++i) {
      table.rows.push_back({cell(task_of(data, one.task)),
                            cell(item(data.interfaces, one.interface)), cell(i + 1), Cell(),
                            cell(item(one.at_turn, i))});
    }
  }
  for (const SuccessionCount& one : results.order.successions) {
    table.rows.push_back({cell(task_of(data, one.task)), cell(item(data.interfaces, one.interface)),
                          Cell(), cell(item(data.interfaces, one.previous)), cell(one.people)});
  }
  return table;
}

HtmlTable shown_balance(const Results& results) {
  const Dataset& data = results.data;
  const int interfaces = size_of(data.interfaces);
  HtmlTable table;
  table.caption =
      "People who had each interface first, second, and so on, and right after another.";
  table.columns = {"task", "interface"};
  table.heads = 2;
  for (int i = 1; i <= interfaces; ++i) table.columns.push_back(fmt::format("turn {}", i));
  for (const std::string& name : data.interfaces) table.columns.push_back("after " + name);
  for (const TurnCount& one : results.order.turn_counts) {
    std::vector<std::string> row = {task_of(data, one.task), item(data.interfaces, one.interface)};
    for (const int people : one.at_turn) row.push_back(std::to_string(people));
    std::vector<std::string> after(data.interfaces.size(), dash);
    for (const SuccessionCount& other : results.order.successions) {
      if (other.task != one.task || other.interface != one.interface) continue;
      item(after, other.previous) = std::to_string(other.people);
    }
    row.insert(row.end(), after.begin(), after.end());
    table.rows.push_back(std::move(row));
  }
  return table;
}

HtmlTable shown_turns(const Results& results) {
  const Dataset& data = results.data;
  HtmlTable table;
  table.caption = "By turn, whatever the interface was: one value per participant.";
  table.columns = {"measure", "turn", "n", "mean", "SD", "95 % CI of the mean", "median"};
  table.heads = 2;
  for (const TurnSummary& one : results.order.turns) {
    const Measure& measure = item(data.measures, one.measure);
    const Moments& m = one.moments;
    table.rows.push_back(
        {measure_in_task(data, one.measure, one.task), std::to_string(one.turn),
         std::to_string(m.n), with_unit(measure, *m.mean), m.sd ? shown(measure, *m.sd) : dash,
         m.mean_ci ? shown_interval(measure, *m.mean_ci) : dash, with_unit(measure, *one.median)});
  }
  return table;
}

HtmlTable shown_learning(const Results& results) {
  const Dataset& data = results.data;
  HtmlTable table;
  table.caption =
      data.interfaces.size() == 2
          ? "First against second turn: per participant the second value minus the first, by the "
            "exact signed-rank test and the sign test; Hodges-Lehmann with 95 % interval. A "
            "negative change of D or time is learning."
          : "Change per turn: per participant the slope of value against turn, by the exact "
            "signed-rank test and the sign test; Hodges-Lehmann with 95 % interval. A negative "
            "change of D or time is learning.";
  table.columns = {"measure", "n", "change per turn [95 % CI]", "p", "up", "down", "sign test p"};
  for (const Learning& one : results.order.learning) {
    if (one.test.n == 0) continue;
    const bool several = one.test.n > 1;
    table.rows.push_back(
        {measure_in_task(data, one.measure, one.task), std::to_string(one.test.n),
         estimate_cell(item(data.measures, one.measure), one.hl, interval_of(one.hl_ci)),
         several ? p_cell(one.p) : dash, std::to_string(one.test.n_positive),
         std::to_string(one.test.n_negative),
         several && one.sign.n > 0 ? p_cell(one.sign.two) : dash});
  }
  return table;
}

HtmlTable shown_carry_over(const Results& results) {
  const Dataset& data = results.data;
  HtmlTable table;
  table.caption =
      "Carry-over: each interface by the one that the person had before. These are different "
      "people, and often few.";
  table.columns = {"measure", "interface", "before it", "n", "mean", "SD", "95 % CI of the mean"};
  table.heads = 3;
  for (const CarryOver& one : results.order.carry_over) {
    const Measure& measure = item(data.measures, one.measure);
    const Moments& m = one.moments;
    table.rows.push_back(
        {measure_in_task(data, one.measure, one.task), item(data.interfaces, one.interface),
         one.previous < 0 ? "nothing" : item(data.interfaces, one.previous), std::to_string(m.n),
         with_unit(measure, *m.mean), m.sd ? shown(measure, *m.sd) : dash,
         m.mean_ci ? shown_interval(measure, *m.mean_ci) : dash});
  }
  return table;
}

}  // namespace

Section order_section(const Results& results) {
  if (results.data.trials.empty()) return {};
  Section section;
  section.title = "Order and learning";
  for (const std::string& one : results.order.sentences) section.html += element("p", one);
  section.html += wide(shown_balance(results));
  if (results.data.interfaces.size() > 1) {
    section.html += wide(shown_turns(results)) + wide(shown_learning(results)) +
                    wide(shown_carry_over(results));
  }
  section.tables = {turn_table(results), learning_table(results), carry_over_table(results),
                    balance_table(results)};
  section.json["order"] = {{"sentences", results.order.sentences}};
  for (const Table& table : section.tables) {
    section.json["order"][table.name.substr(6)] = json_rows(table);
  }
  return section;
}

}  // namespace promenade::analysis
