#include "analysis/format.h"
#include "analysis/item.h"
#include "analysis/report/cells.h"
#include "analysis/report/report_sections.h"

namespace promenade::analysis {
namespace {

using Json = nlohmann::json;

std::string sentence_on_seal(const PreregCheck& check) {
  switch (check.seal) {
    case SealState::sealed:
      return "The plan was sealed in the database before the first session.";
    case SealState::late:
      return "The plan was sealed late: some sessions ran before.";
    case SealState::other:
      return "This is not the plan that was sealed in the database.";
    case SealState::none:
      return "The plan was never sealed: nobody can tell whether it is older than the data.";
  }
  return "";
}

std::string sentence_on_tests(const PreregCheck& check) {
  return "By the plan, " + count_of(size_of(check.tests), "test is", "tests are") +
         " confirmatory, at alpha = " + exact_number(check.plan.alpha) +
         (check.plan.family == HolmFamily::all
              ? " after Holm's correction over all of them"
              : " after Holm's correction over the pairs of one measure in one task") +
         "; the other " + count_of(check.exploratory, "test", "tests") + " of this report " +
         (check.exploratory == 1 ? "is" : "are") + " exploratory.";
}

Html deviations_html(const PreregCheck& check) {
  if (check.deviations.empty()) return element("p", "Nothing was done otherwise.");
  HtmlTable table{"What was done otherwise", {"about", "planned", "found"}, {}, {}};
  for (const PlanDeviation& one : check.deviations) {
    table.rows.push_back({one.about, one.planned, one.found});
  }
  return wide_words(table);
}

std::string significance_word(const PreregCheck& check, const PlannedTest& test) {
  if (!test.p_holm) return "no test";
  return *test.p_holm <= check.plan.alpha ? "significant" : "not significant";
}

Html tests_html(const Results& results, const PreregCheck& check) {
  HtmlTable table{"The tests that were planned",
                  {"measure", "task", "difference", "n", "estimate", "95 % interval", "p",
                   "p (Holm)", "by the plan"},
                  {},
                  {}};
  for (const PlannedTest& test : check.tests) {
    std::vector<std::string> row = {test.measure, test.task, test.a + " − " + test.b};
    if (test.comparison < 0 || !test.p_holm) {
      row.insert(row.end(), {"0", dash, dash, dash, dash});
    } else {
      const Comparison& one = item(results.comparisons, test.comparison);
      const Measure& measure = item(results.data.measures, one.measure);
      row.insert(row.end(), {std::to_string(one.test.n), with_unit(measure, *one.hl),
                             one.hl_ci ? shown_interval(measure, one.hl_ci->interval)
                                       : std::string("not attainable"),
                             p_cell(*one.p), p_cell(*test.p_holm)});
    }
    row.push_back(significance_word(check, test));
    table.rows.push_back(std::move(row));
  }
  table.heads = 3;
  return wide(table);
}

Table deviation_table(const PreregCheck& check) {
  Table table{"prereg_deviations",
              "What was done otherwise than registered.",
              {"about", "planned", "found"},
              {}};
  for (const PlanDeviation& one : check.deviations) {
    table.rows.push_back({one.about, one.planned, one.found});
  }
  return table;
}

std::vector<Cell> role_cells(const PlannedTest* test, double alpha) {
  if (!test) return {std::string("exploratory"), Cell(), Cell()};
  if (!test->p_holm) return {std::string("confirmatory"), Cell(), Cell()};
  return {std::string("confirmatory"), *test->p_holm, std::int64_t{*test->p_holm <= alpha}};
}

// Every comparison of the report with its role.
Table test_table(const Results& results, const PreregCheck& check) {
  const Dataset& data = results.data;
  std::vector<const PlannedTest*> planned(results.comparisons.size());
  for (const PlannedTest& one : check.tests) {
    if (one.comparison >= 0) item(planned, one.comparison) = &one;
  }
  Table table{
      "prereg_tests",
      "Which tests were planned; Holm's correction as the plan says.",
      {"measure", "task", "target", "pooling", "a", "b", "p", "role", "p_holm_plan", "significant"},
      {}};
  for (int i = 0; i < size_of(results.comparisons); ++i) {
    const Comparison& one = item(results.comparisons, i);
    const Task& task = item(data.tasks, one.task);
    std::vector<Cell> row = {item(data.measures, one.measure).name,
                             task.name,
                             one.target < 0 ? Cell() : Cell(item(task.targets, one.target)),
                             to_text(one.pooling),
                             item(data.interfaces, one.a),
                             item(data.interfaces, one.b),
                             one.p ? Cell(*one.p) : Cell()};
    for (Cell& cell : role_cells(item(planned, i), check.plan.alpha))
      row.push_back(std::move(cell));
    table.rows.push_back(std::move(row));
  }
  return table;
}

Json optional_json(const std::optional<double>& value) { return value ? Json(*value) : Json(); }

Json test_json(const PlannedTest& test, const Comparison* one, double alpha) {
  Json json = {{"measure", test.measure}, {"task", test.task}, {"a", test.a}, {"b", test.b}};
  json["n"] = one ? one->test.n : 0;
  json["p"] = one ? optional_json(one->p) : Json();
  json["p_holm"] = optional_json(test.p_holm);
  json["significant"] = test.p_holm ? Json(*test.p_holm <= alpha) : Json();
  json["hl"] = one ? optional_json(one->hl) : Json();
  json["hl_ci"] = Json();
  if (one && one->hl_ci) {
    json["hl_ci"] = Json::array({one->hl_ci->interval.lower, one->hl_ci->interval.upper});
  }
  return json;
}

Json tests_json(const Results& results, const PreregCheck& check) {
  Json tests = Json::array();
  for (const PlannedTest& test : check.tests) {
    const bool made = test.comparison >= 0;
    tests.push_back(test_json(test, made ? &item(results.comparisons, test.comparison) : nullptr,
                              check.plan.alpha));
  }
  return tests;
}

Json prereg_json(const Results& results, const PreregCheck& check) {
  Json deviations = Json::array();
  for (const PlanDeviation& one : check.deviations) {
    deviations.push_back({{"about", one.about}, {"planned", one.planned}, {"found", one.found}});
  }
  return {{"file", check.file},
          {"sha256", check.sha256},
          {"seal", to_text(check.seal)},
          {"participants_planned", check.plan.participants},
          {"participants_analysed", results.selection.count(Disposition::analysed)},
          {"alpha", check.plan.alpha},
          {"family", check.plan.family == HolmFamily::all ? "all" : "measure"},
          {"deviations", std::move(deviations)},
          {"tests", tests_json(results, check)},
          {"exploratory", check.exploratory}};
}

}  // namespace

Section prereg_section(const Results& results) {
  Section section;
  if (!results.prereg) return section;
  const PreregCheck& check = *results.prereg;
  section.title = "Preregistration";
  section.html = element("p", sentence_on_seal(check)) +
                 element("p", "Document: " + check.file + ", SHA-256 " + check.sha256 + ".") +
                 deviations_html(check) + element("p", sentence_on_tests(check)) +
                 tests_html(results, check);
  section.tables = {deviation_table(check), test_table(results, check)};
  section.json["prereg"] = prereg_json(results, check);
  return section;
}

}  // namespace promenade::analysis
