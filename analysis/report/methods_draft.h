// The method of this very study in sentences that an author can take and change.
#pragma once

#include <string>
#include <vector>

#include "analysis/results.h"

namespace promenade::analysis {

// Paragraphs: participants, design, measures, tests, program. They name what was used and
// nothing else.
std::vector<std::string> methods_draft(const Results& results);

}  // namespace promenade::analysis
