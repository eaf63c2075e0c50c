// The works behind the tests of a report, as a paper would cite them.
#pragma once

#include <string>
#include <vector>

#include "analysis/results.h"

namespace promenade::analysis {

struct Reference {
  std::string use;   // "differences": what it stands for
  std::string text;  // authors, year, title, where
};

// Are failures tested: is there a pair of interfaces, and has anybody failed?
bool tests_failures(const Results& results);

// Of those tests that this report holds, by author.
std::vector<Reference> references_of(const Results& results);

}  // namespace promenade::analysis
