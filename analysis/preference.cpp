#include "analysis/preference.h"

#include <algorithm>
#include <map>
#include <numeric>

#include "analysis/item.h"
#include "analysis/statistics/p_adjust.h"
#include "analysis/statistics/proportion.h"
#include "analysis/statistics/sign_test.h"

namespace promenade::analysis {
namespace {

// The words of the answer, or the name of that number in the study.
std::string name_in(const study::ItemAnswer& answer, const std::vector<std::string>& interfaces) {
  if (!answer.text.empty()) return answer.text;
  for (int i = 0; i < size_of(interfaces); ++i) {
    if (answer.value == i + 1) return item(interfaces, i);
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

std::vector<std::string> preferred(const std::vector<FilledPage>& pages,
                                   const std::vector<std::string>& interfaces) {
  std::map<int, std::string> name_of;  // by person; the last one stays
  for (const FilledPage& page : pages) {
    const auto answer = page.answers.find("preferred");
    if (page.instrument != "preference" || answer == page.answers.end()) continue;
    if (!answer->second.declined) name_of[page.person] = name_in(answer->second, interfaces);
  }
  std::vector<std::string> names;
  for (const auto& [person, name] : name_of) {
    if (!name.empty()) names.push_back(name);
  }
  return names;
}

}  // namespace promenade::analysis
