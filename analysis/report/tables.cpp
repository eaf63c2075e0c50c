#include "analysis/report/tables.h"

#include "analysis/format.h"
#include "analysis/item.h"
#include "analysis/report/cells.h"
#include "study/csv.h"

namespace promenade::analysis {
namespace {

const std::vector<std::string>& comparison_columns() {
  static const std::vector<std::string> columns = {"measure",
                                                   "unit",
                                                   "task",
                                                   "target",
                                                   "pooling",
                                                   "a",
                                                   "b",
                                                   "n",
                                                   "n_missing",
                                                   "n_zero",
                                                   "n_tied",
                                                   "tie_sum",
                                                   "W_plus",
                                                   "W_minus",
                                                   "p_exact_two",
                                                   "p_asym_two",
                                                   "p_asym_cc_two",
                                                   "p_holm",
                                                   "holm_family",
                                                   "p_holm_from",
                                                   "rank_biserial",
                                                   "rank_biserial_ci_lower",
                                                   "rank_biserial_ci_upper",
                                                   "hl",
                                                   "hl_ci_lower",
                                                   "hl_ci_upper",
                                                   "hl_ci_level"};
  return columns;
}

std::vector<Cell> comparison_row(const Dataset& data, const Comparison& one) {
  const SignedRankTest& test = one.test;
  const bool any = test.n > 0;
  return {cell(item(data.measures, one.measure).name),
          cell(item(data.measures, one.measure).unit),
          cell(item(data.tasks, one.task).name),
          target_name(data, one.task, one.target),
          cell(to_text(one.pooling)),
          cell(item(data.interfaces, one.a)),
          cell(item(data.interfaces, one.b)),
          cell(test.n),
          cell(one.missing),
          cell(test.n_zero),
          cell(test.n_tied),
          cell(test.tie_sum),
          Cell(test.w_plus),
          Cell(test.w_minus),
          any && test.exact ? Cell(test.exact->two) : Cell(),
          test.normal ? Cell(test.normal->two) : Cell(),
          test.normal_corrected ? Cell(test.normal_corrected->two) : Cell(),
          cell(one.p_holm),
          cell(one.family),
          one.p ? cell(is_approximate(one) ? "asymptotic" : "exact") : Cell(),
          cell(test.rank_biserial),
          lower(one.rank_biserial_ci),
          upper(one.rank_biserial_ci),
          cell(one.hl),
          lower(interval_of(one.hl_ci)),
          upper(interval_of(one.hl_ci)),
          one.hl_ci ? Cell(one.hl_ci->level) : Cell()};
}

Table comparison_table(const Results& results) {
  Table table{"comparisons",
              "Every pair of interfaces (differences are a − b) by the signed-rank test.",
              comparison_columns(),
              {}};
  for (const Comparison& one : results.comparisons) {
    table.rows.push_back(comparison_row(results.data, one));
  }
  return table;
}

Table failure_table(const Results& results) {
  const Dataset& data = results.data;
  Table table{
      "failures",
      "Failed trials per interface and task with the 95 % intervals of Wilson and of Clopper "
      "and Pearson.",
      {"task", "target", "interface", "trials", "failed", "timeouts", "ratio", "wilson_lower",
       "wilson_upper", "clopper_pearson_lower", "clopper_pearson_upper"},
      {}};
  for (const FailureRatio& one : results.failures) {
    table.rows.push_back(
        {cell(item(data.tasks, one.task).name), target_name(data, one.task, one.target),
         cell(item(data.interfaces, one.interface)), cell(one.trials), cell(one.failed),
         cell(one.timeouts), Cell(static_cast<double>(one.failed) / one.trials), lower(one.wilson),
         upper(one.wilson), lower(one.clopper_pearson), upper(one.clopper_pearson)});
  }
  return table;
}

Table summary_table(const Results& results) {
  const Dataset& data = results.data;
  Table table{"summaries",
              "Each interface by itself; one value per participant, the mean over targets.",
              {"measure", "unit", "task", "interface", "n", "mean", "sd", "median",
               "median_ci_lower", "median_ci_upper"},
              {}};
  for (const Summary& one : results.summaries) {
    table.rows.push_back(
        {cell(item(data.measures, one.measure).name), cell(item(data.measures, one.measure).unit),
         cell(item(data.tasks, one.task).name), cell(item(data.interfaces, one.interface)),
         cell(one.n), cell(one.mean), cell(one.sd), cell(one.median), lower(one.median_ci),
         upper(one.median_ci)});
  }
  return table;
}

Table participant_table(const Results& results) {
  Table table{"participants",
              "Everyone who began, and what became of them.",
              {"participant", "status", "reason", "simulated", "pilot", "station", "sequence",
               "study_version"},
              {}};
  const Log& log = results.log;
  for (const Person& person : results.selection.people) {
    std::vector<Cell> row = {cell(person.code), cell(to_text(person.disposition)),
                             cell(person.reason), cell(person.simulated), cell(person.pilot)};
    if (person.session < 0) {
      row.resize(table.columns.size());
    } else {
      const LoggedSession& session = item(log.sessions, person.session);
      row.insert(row.end(), {cell(session.station), cell(session.sequence),
                             cell(item(log.versions, session.version).version)});
    }
    table.rows.push_back(std::move(row));
  }
  return table;
}

Table value_table(const Results& results) {
  const Dataset& data = results.data;
  Table table{"values",
              "One value per participant, interface, task and measure: what the tests compare.",
              {"participant", "interface", "task", "measure", "unit", "value"},
              {}};
  for (const Summary& one : results.summaries) {
    for (int person = 0; person < size_of(one.values); ++person) {
      if (!item(one.values, person)) continue;
      table.rows.push_back(
          {cell(item(data.people, person)), cell(item(data.interfaces, one.interface)),
           cell(item(data.tasks, one.task).name), cell(item(data.measures, one.measure).name),
           cell(item(data.measures, one.measure).unit), cell(item(one.values, person))});
    }
  }
  return table;
}

std::string kind_word(MeasureKind kind) {
  switch (kind) {
    case MeasureKind::result:
      return "result";
    case MeasureKind::rating:
      return "rating";
    case MeasureKind::process:
      return "process";
  }
  return "";
}

Table measure_table(const Results& results) {
  Table table{"measures",
              "What is measured: a column of trials each.",
              {"measure", "label", "unit", "kind"},
              {}};
  for (const Measure& measure : results.data.measures) {
    table.rows.push_back({cell(measure.name), cell(measure.label), cell(measure.unit),
                          cell(kind_word(measure.kind))});
  }
  return table;
}

Table trial_table(const Results& results) {
  const Dataset& data = results.data;
  Table table{"trials",
              "Every trial that counts.",
              {"participant", "session", "trial", "station", "study_version", "block", "position",
               "interface", "previous_interface", "task", "target", "outcome", "failed"},
              {}};
  for (const Measure& measure : data.measures) table.columns.push_back(measure.name);
  for (const Trial& trial : data.trials) {
    const LoggedTrial& logged = item(results.log.trials, trial.logged);
    const LoggedSession& session = item(results.log.sessions, logged.session);
    const bool first = trial.previous_interface < 0;
    std::vector<Cell> row = {cell(item(data.people, trial.person)),
                             cell(session.uuid),
                             cell(logged.uuid),
                             cell(session.station),
                             cell(item(results.log.versions, session.version).version),
                             cell(trial.block),
                             cell(trial.position),
                             cell(item(data.interfaces, trial.interface)),
                             first ? Cell() : item(data.interfaces, trial.previous_interface),
                             cell(item(data.tasks, trial.task).name),
                             target_name(data, trial.task, trial.target),
                             cell(trial.outcome),
                             cell(trial.failed)};
    for (const auto& value : trial.values) row.push_back(cell(value));
    table.rows.push_back(std::move(row));
  }
  return table;
}

struct CsvField {
  std::string operator()(std::monostate) const { return ""; }
  std::string operator()(std::int64_t value) const { return std::to_string(value); }
  std::string operator()(double value) const { return exact_number(value); }
  std::string operator()(const std::string& text) const { return study::csv_cell(text); }
};

}  // namespace

std::vector<Table> make_tables(const Results& results) {
  return {comparison_table(results),  failure_table(results), summary_table(results),
          participant_table(results), value_table(results),   trial_table(results),
          measure_table(results)};
}

std::string to_csv(const Table& table) {
  std::string csv;
  for (std::size_t i = 0; i < table.columns.size(); ++i) {
    csv += (i > 0 ? "," : "") + CsvField()(table.columns[i]);
  }
  csv += '\n';
  for (const std::vector<Cell>& row : table.rows) {
    for (std::size_t i = 0; i < row.size(); ++i) {
      csv += (i > 0 ? "," : "") + std::visit(CsvField(), row[i]);
    }
    csv += '\n';
  }
  return csv;
}

std::string to_text(Pooling pooling) {
  switch (pooling) {
    case Pooling::none:
      return "none";
    case Pooling::participants:
      return "participants";
    case Pooling::trials:
      return "trials";
  }
  return "";
}

std::string to_text(Disposition disposition) {
  switch (disposition) {
    case Disposition::declined:
      return "declined";
    case Disposition::withdrawn:
      return "withdrawn";
    case Disposition::unfinished:
      return "unfinished";
    case Disposition::excluded:
      return "excluded";
    case Disposition::analysed:
      return "analysed";
  }
  return "";
}

}  // namespace promenade::analysis
