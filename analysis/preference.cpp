#include "analysis/preference.h"

#include <algorithm>
#include <map>
#include <numeric>

#include "analysis/item.h"
#include "analysis/statistics/p_adjust.h"
#include "analysis/statistics/proportion.h"
#include "analysis/statistics/sign_test.h"
#include "study/outline.h"
#include "study/sqlite.h"

namespace promenade::analysis {
namespace {

constexpr const char* preference_query =
    "SELECT session, text, value FROM answer WHERE instrument = 'preference' "
    "AND item = 'preferred' AND declined = 0 AND touched = 1 ORDER BY session, t_us";

// The words of the answer, or the name of that number in the study.
std::string name_in(const study::Statement& row, const std::vector<std::string>& interfaces) {
  if (!row.text(1).empty()) return row.text(1);
  const double number = row.is_null(2) ? 0 : row.real(2);
  for (int i = 0; i < size_of(interfaces); ++i) {
    if (number == i + 1) return item(interfaces, i);
  }
  return "";
}

void add_pairs(Preference& preference) {
  std::vector<double> p;
  for (int a = 0; a < size_of(preference.choices); ++a) {
    for (int b = a + 1; b < size_of(preference.choices); ++b) {
      const double two = sign_test(item(preference.counts, a), item(preference.counts, b)).two;
      preference.pairs.push_back({a, b, two, 1});
      p.push_back(two);
    }
  }
  const std::vector<double> adjusted = adjust_holm(p);
  for (std::size_t i = 0; i < adjusted.size(); ++i) preference.pairs[i].p_holm = adjusted[i];
}

}  // namespace

Preference preference_of(std::vector<std::string> interfaces,
                         const std::vector<std::string>& names) {
  Preference preference;
  preference.choices = std::move(interfaces);
  for (const std::string& name : names) {
    auto& choices = preference.choices;
    if (std::find(choices.begin(), choices.end(), name) == choices.end()) choices.push_back(name);
  }
  for (const std::string& choice : preference.choices) {
    preference.counts.push_back(static_cast<int>(std::count(names.begin(), names.end(), choice)));
  }
  if (preference.choices.size() < 2) return preference;
  preference.n = size_of(names);
  for (const int count : preference.counts) {
    preference.intervals.push_back(clopper_pearson_interval(count, preference.n));
  }
  if (preference.choices.size() > 2 && preference.n > 0) {
    preference.test = equal_choices(preference.counts);
  }
  add_pairs(preference);
  return preference;
}

std::vector<std::string> preferred(const std::vector<std::string>& databases, const Log& log,
                                   const Selection& selection) {
  const std::vector<std::string> interfaces = study::outline_of(log.config_text).interfaces;
  std::map<std::string, std::string> name_of;  // by session; the last one stays
  for (const std::string& file : databases) {
    study::Database database = open_database(file);
    study::Statement row(database, preference_query);
    while (row.step()) name_of[row.text(0)] = name_in(row, interfaces);
  }
  std::vector<std::string> names;
  for (const Person& person : selection.people) {
    if (person.disposition != Disposition::analysed) continue;
    const auto found = name_of.find(item(log.sessions, person.session).uuid);
    if (found != name_of.end() && !found->second.empty()) names.push_back(found->second);
  }
  return names;
}

}  // namespace promenade::analysis
