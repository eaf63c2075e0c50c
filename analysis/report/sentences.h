// What the data say, in words that stay true for one person, one interface and
// differences that are all zero.
#pragma once

#include <string>
#include <vector>

#include "analysis/results.h"

namespace promenade::analysis {

inline constexpr double significance = 0.05;

bool is_significant(const Comparison& comparison);

// One sentence on a pair of interfaces: "With map people came 0.9 cm closer than
// with labels (95 % CI 0.4 to 1.5; n = 37; exact p = .004, Holm over 10 pairs)."
std::string sentence_on(const Dataset& data, const Comparison& comparison);

// On one measure in one task: the pair with the largest difference among those that
// differ significantly (else among all), or the values of the only interface. Where there are
// several tasks it begins with the name of this one.
std::string sentence_on_measure(const Results& results, int measure, int task);

// Where the first page looks: D, the asked quality of what was found, and time, each of the first
// task that has it.
struct Spotlight {
  int measure = 0;
  int task = 0;
};
std::vector<Spotlight> spotlights(const Results& results);

// What limits the conclusions; each a sentence.
std::vector<std::string> caveats(const Results& results);

}  // namespace promenade::analysis
