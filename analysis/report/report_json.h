// Every number of a report as JSON (docs/commands.md). Lengths in metres, times in
// seconds; what is not defined is null.
#pragma once

#include <string>
#include <vector>

#include "analysis/report/section.h"
#include "analysis/results.h"

namespace promenade::analysis {

std::string report_json(const Results& results, const std::vector<Section>& sections);

}  // namespace promenade::analysis
