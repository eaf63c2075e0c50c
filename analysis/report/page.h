// report.html: one file without scripts and outside resources, readable in grey
// print on A4. The first page says what came out; tables, method and provenance
// follow.
#pragma once

#include <string>
#include <vector>

#include "analysis/report/figures.h"
#include "analysis/report/section.h"
#include "analysis/results.h"

namespace promenade::analysis {

std::string report_page(const Results& results, const std::vector<Section>& sections,
                        const std::vector<DrawnFigure>& figures);

}  // namespace promenade::analysis
