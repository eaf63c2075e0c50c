#include "app/commands/power_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "analysis/format.h"

namespace promenade::app {
namespace {

using analysis::PowerRow;
using analysis::PowerTable;
using analysis::Rate;

bool is_rehearsal(const PowerReport& report) { return report.pilot_files.empty(); }

Json rate_json(const Rate& rate) {
  const analysis::Interval interval = rate.interval();
  return {{"found", rate.found},
          {"power", rate.share()},
          {"se", rate.standard_error()},
          {"ci", {interval.lower, interval.upper}}};
}

Json row_json(const PowerReport& report, const PowerRow& row) {
  Json json = {{"a", row.a},
               {"b", row.b},
               {"participants", row.participants},
               {"balanced", row.participants % report.round == 0},
               {"studies", row.holm.studies}};
  json.update(rate_json(row.holm));
  json["without_holm"] = rate_json(row.alone);
  json["hl_median"] = to_json(row.hl);
  json["paired_t"] = to_json(row.paired_t);
  json["sign_flips"] = to_json(row.sign_flips);
  return json;
}

Json table_json(const PowerReport& report, const PowerTable& table) {
  Json json = {{"task", table.task}, {"measure", table.measure.name}, {"unit", table.measure.unit}};
  json["rows"] = Json::array();
  for (const PowerRow& row : table.rows) json["rows"].push_back(row_json(report, row));
  json["any_pair"] = Json::array();
  for (const auto& [participants, rate] : table.any) {
    Json one = {{"participants", participants}};
    one.update(rate_json(rate));
    json["any_pair"].push_back(std::move(one));
  }
  return json;
}

Json people_json(const study::Tendencies& people) {
  return {{"noise", people.noise},
          {"learning", people.learning},
          {"fatigue", people.fatigue},
          {"difficulty", people.difficulty},
          {"preference", people.preference},
          {"aptitude", people.aptitude},
          {"taste", people.taste}};
}

std::string percent(double share) { return fmt::format("{:.1f}", 100 * share); }

std::string range(const Rate& rate) {
  const analysis::Interval interval = rate.interval();
  return percent(interval.lower) + " to " + percent(interval.upper);
}

std::string optional_percent(const std::optional<double>& share) {
  return share ? percent(*share) : "-";
}

std::string row_text(const PowerReport& report, const PowerTable& table, const PowerRow& row) {
  const std::string mark = row.participants % report.round == 0 ? " " : "*";
  return fmt::format("{:>8}{}{:>10}{:>17}{:>8}{:>14}{:>10}{:>8}   {}\n", row.participants, mark,
                     percent(row.holm.share()), range(row.holm), percent(row.holm.standard_error()),
                     percent(row.alone.share()), optional_percent(row.paired_t),
                     optional_percent(row.sign_flips),
                     row.hl ? analysis::with_unit(table.measure, *row.hl) : "-");
}

// With n people the smallest exact p is 2 / 2^n, and Holm asks the first of m pairs for m times it.
int fewest_that_can_find(double alpha, int pairs) {
  int people = 1;
  while (people < 60 && pairs * std::ldexp(1.0, 1 - people) > alpha) ++people;
  return people;
}

// Of the task with the fewest; 0 where one pair alone was asked about.
int fewest_pairs(const PowerReport& report) {
  if (!report.effect.a.empty()) return 0;
  const std::size_t sizes = std::max<std::size_t>(report.question.participants.size(), 1);
  std::size_t fewest = report.tables.front().rows.size();
  for (const PowerTable& table : report.tables) fewest = std::min(fewest, table.rows.size());
  return static_cast<int>(fewest / sizes);
}

std::string too_few_text(const PowerReport& report) {
  const int pairs = fewest_pairs(report);
  const int fewest = fewest_that_can_find(report.question.alpha, pairs);
  if (pairs == 0 || report.question.participants.front() >= fewest) return "";
  return fmt::format(
      "With fewer than {} people this test can find nothing: the smallest p that there is, times\n"
      "{} for Holm, is above {}.\n",
      fewest, analysis::count_of(pairs, "pair", "pairs"),
      analysis::exact_number(report.question.alpha));
}

std::string pair_text(const PowerReport& report, const PowerTable& table, std::size_t first) {
  const std::string a = table.rows[first].a;
  const std::string b = table.rows[first].b;
  std::string text = fmt::format(
      "\n{}, {}: {} minus {}\n  people  power in %          95 %    s.e.  without Holm"
      "  paired t   signs   median estimate\n",
      table.task, table.measure.label, a, b);
  for (const PowerRow& row : table.rows) {
    if (row.a == a && row.b == b) text += row_text(report, table, row);
  }
  const auto people = analysis::enough(table.rows, a, b);
  text += people ? fmt::format("  80 % is reached with {} people.\n", *people)
                 : std::string("  80 % is not reached with any of these numbers.\n");
  return text;
}

std::string any_text(const PowerTable& table) {
  std::string text = fmt::format("\n{}, {}: at least one pair\n", table.task, table.measure.label);
  for (const auto& [participants, rate] : table.any) {
    text += fmt::format("{:>8} {:>10}{:>17}\n", participants, percent(rate.share()), range(rate));
  }
  return text;
}

std::string table_text(const PowerReport& report, const PowerTable& table) {
  std::string text;
  for (std::size_t i = 0; i < table.rows.size(); ++i) {
    const bool first =
        i == 0 || table.rows[i].a != table.rows[i - 1].a || table.rows[i].b != table.rows[i - 1].b;
    if (first) text += pair_text(report, table, i);
  }
  const bool several = table.rows.size() > table.any.size();
  return several && !table.any.empty() ? text + any_text(table) : text;
}

std::string pilot_heading(const PowerReport& report) {
  const analysis::Measure& measure = report.tables.front().measure;
  std::string text = fmt::format(
      "Power of study \"{}\" by RESAMPLING A PILOT of {}, {} studies of each size, seed {}.\n"
      "The pilot's own differences are taken out; the smallest effect that matters is put in: "
      "{}.\n",
      report.study,
      analysis::count_of(report.pilot_people,
                         report.pilot_simulated ? "simulated person" : "person",
                         report.pilot_simulated ? "simulated people" : "people"),
      report.question.studies, report.question.seed,
      analysis::with_unit(measure, report.effect.effect));
  if (report.pilot_people < 10) {
    text += "So few people say little about how much people differ: take this as a rough guess.\n";
  }
  return text;
}

std::string rehearsal_heading(const PowerReport& report) {
  return fmt::format(
      "A REHEARSAL of study \"{}\" with simulated people, {} studies of each size, seed {}.\n"
      "It shows what the study would find if people were like them. How real people differ,\n"
      "only a pilot can tell: promenade power ... --from PILOT.db --effect X\n",
      report.study, report.question.studies, report.question.seed);
}

std::string footing(const PowerReport& report) {
  std::string text = fmt::format(
      "\nPower: how often the exact signed-rank test on one value per person, with Holm over the\n"
      "pairs, has p <= {}. 95 %: what the number of drawn studies leaves open. Paired t and "
      "signs:\n"
      "two formulas for the test without Holm (docs/methods.md, 6).\n",
      analysis::exact_number(report.question.alpha));
  text += too_few_text(report);
  if (report.round > 1) {
    text += fmt::format("* not balanced: plan with a multiple of {} people.\n", report.round);
  }
  return text;
}

}  // namespace

Json power_json(const PowerReport& report) {
  const bool rehearsal = is_rehearsal(report);
  Json json = {{"study", report.study},
               {"sha256", report.sha256},
               {"method", rehearsal ? "rehearsal" : "resampling"},
               {"participants", report.question.participants},
               {"studies", report.question.studies},
               {"seed", report.question.seed},
               {"alpha", report.question.alpha},
               {"round", report.round}};
  if (rehearsal) {
    json["simulated_people"] = people_json(report.tendencies);
  } else {
    const bool each = report.effect.a.empty();
    json["pilot"] = {{"databases", report.pilot_files},
                     {"people", report.pilot_people},
                     {"all_simulated", report.pilot_simulated}};
    json["effect"] = {{"value", report.effect.effect},
                      {"a", each ? Json() : Json(report.effect.a)},
                      {"b", each ? Json() : Json(report.effect.b)}};
  }
  json["tables"] = Json::array();
  for (const PowerTable& table : report.tables) json["tables"].push_back(table_json(report, table));
  return json;
}

std::string power_text(const PowerReport& report) {
  if (report.tables.empty()) return "Nothing is compared in this study.\n";
  std::string text = is_rehearsal(report) ? rehearsal_heading(report) : pilot_heading(report);
  for (const PowerTable& table : report.tables) text += table_text(report, table);
  return text + footing(report);
}

}  // namespace promenade::app
