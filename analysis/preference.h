// Which interface people would take: the forced choice of the instrument `preference`.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "analysis/questionnaires.h"
#include "analysis/statistics/interval.h"
#include "analysis/statistics/multinomial.h"

namespace promenade::analysis {

// The exact two-sided binomial test against 1/2 of those who chose a or b.
struct PreferencePair {
  int a = 0, b = 0;  // choices
  double p = 1;
  double p_holm = 1;  // over all pairs
};

struct Preference {
  std::vector<std::string> choices;  // the interfaces, also those that nobody chose
  std::vector<int> counts;
  std::vector<Interval> intervals;   // of count / n by Clopper & Pearson, 95 %
  int n = 0;                         // who answered; 0: nobody, or there was nothing to choose
  std::optional<EqualChoices> test;  // with three choices or more
  std::vector<PreferencePair> pairs;
};

// names: what each person chose. A name that is not among the interfaces becomes a choice too.
Preference preference_of(std::vector<std::string> interfaces,
                         const std::vector<std::string>& names);

// What people answered, the last answer of each, by person. `interfaces`: all of the study, in its
// order, for answers without words.
std::vector<std::string> preferred(const std::vector<FilledPage>& pages,
                                   const std::vector<std::string>& interfaces);

}  // namespace promenade::analysis
