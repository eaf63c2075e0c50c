// Every number of a report as JSON (docs/commands.md). Lengths in metres, times in
// seconds; what is not defined is null.
#pragma once

#include <string>

#include "analysis/results.h"

namespace promenade::analysis {

std::string report_json(const Results& results);

}  // namespace promenade::analysis
