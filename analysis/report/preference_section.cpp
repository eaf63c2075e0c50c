// Which interface people would take.
#include <fmt/format.h>

#include "analysis/format.h"
#include "analysis/item.h"
#include "analysis/report/cells.h"
#include "analysis/report/report_sections.h"
#include "analysis/report/sentences.h"

namespace promenade::analysis {
namespace {

const std::string& name_of(const Preference& preference, int choice) {
  return item(preference.choices, choice);
}

double share_of(const Preference& preference, int choice) {
  return static_cast<double>(item(preference.counts, choice)) / preference.n;
}

HtmlTable choice_table(const Preference& preference) {
  HtmlTable table;
  table.caption =
      fmt::format("“Which of these controls would you rather use?”, {}, one choice each.",
                  count_of(preference.n, "answer", "answers"));
  table.columns = {"interface", "chosen", "share", "95 % CI (Clopper-Pearson)"};
  for (int i = 0; i < size_of(preference.choices); ++i) {
    table.rows.push_back({name_of(preference, i), std::to_string(item(preference.counts, i)),
                          percent(share_of(preference, i)),
                          percent_interval(item(preference.intervals, i))});
  }
  return table;
}

HtmlTable pair_table(const Preference& preference) {
  HtmlTable table;
  table.caption =
      "Pairs: the exact binomial test against one half of those who chose one of the two. Holm’s "
      "family: all pairs.";
  table.columns = {"a, b", "chose a", "chose b", "exact p", "Holm p"};
  for (const PreferencePair& pair : preference.pairs) {
    table.rows.push_back({name_of(preference, pair.a) + ", " + name_of(preference, pair.b),
                          std::to_string(item(preference.counts, pair.a)),
                          std::to_string(item(preference.counts, pair.b)), p_cell(pair.p),
                          p_cell(pair.p_holm)});
    table.strong.push_back(pair.p_holm < significance);
  }
  return table;
}

// "14 of 17 chose map (82 %, 95 % CI 57 to 96 %; exact binomial p = .013)."
std::string sentence_on_two(const Preference& preference) {
  const int first = item(preference.counts, 0) >= item(preference.counts, 1) ? 0 : 1;
  return fmt::format("{} of {} chose {} ({}, 95 % CI {}; exact two-sided binomial p {}).",
                     item(preference.counts, first), preference.n, name_of(preference, first),
                     percent(share_of(preference, first)),
                     percent_interval(item(preference.intervals, first)),
                     p_text(preference.pairs[0].p));
}

std::string sentence_on_many(const EqualChoices& test) {
  if (test.p_exact) {
    return fmt::format("That all are chosen equally often: exact multinomial p {}.",
                       p_text(*test.p_exact));
  }
  return fmt::format(
      "That all are chosen equally often: χ² = {}, p {}, by the χ² approximation, since there are "
      "too many ways to choose to count them.",
      fixed(test.chi2, 2), p_text(test.p_chi2));
}

Table choice_rows(const Preference& preference) {
  Table table{"preference",
              "Which interface people would rather use, with the interval of Clopper and Pearson.",
              {"interface", "chosen", "n", "share", "ci_lower", "ci_upper"},
              {}};
  for (int i = 0; i < size_of(preference.choices); ++i) {
    table.rows.push_back({cell(name_of(preference, i)), cell(item(preference.counts, i)),
                          cell(preference.n), cell(share_of(preference, i)),
                          lower(item(preference.intervals, i)),
                          upper(item(preference.intervals, i))});
  }
  return table;
}

Table test_rows(const Preference& preference) {
  Table table{"preference_tests",
              "Tests of the preference: pairs by the exact binomial test; a and b empty: all.",
              {"a", "b", "chose_a", "chose_b", "p_exact", "p_holm", "chi2", "p_chi2"},
              {}};
  if (preference.test) {
    table.rows.push_back({{},
                          {},
                          {},
                          {},
                          cell(preference.test->p_exact),
                          {},
                          cell(preference.test->chi2),
                          cell(preference.test->p_chi2)});
  }
  for (const PreferencePair& pair : preference.pairs) {
    table.rows.push_back({cell(name_of(preference, pair.a)),
                          cell(name_of(preference, pair.b)),
                          cell(item(preference.counts, pair.a)),
                          cell(item(preference.counts, pair.b)),
                          cell(pair.p),
                          cell(pair.p_holm),
                          {},
                          {}});
  }
  return table;
}

}  // namespace

Section preference_section(const Results& results) {
  const Preference& preference = results.preference;
  if (preference.n == 0) return {};
  Section section;
  section.title = "Preference";
  section.html = element(
      "p", preference.test ? sentence_on_many(*preference.test) : sentence_on_two(preference));
  section.html += wide(choice_table(preference));
  if (preference.test) section.html += wide(pair_table(preference));
  section.tables = {choice_rows(preference), test_rows(preference)};
  for (const Table& table : section.tables) section.json[table.name] = json_rows(table);
  return section;
}

}  // namespace promenade::analysis
