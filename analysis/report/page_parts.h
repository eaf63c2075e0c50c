// The sections of report.html, in the order in which they stand.
#pragma once

#include "analysis/report/html.h"
#include "analysis/report/page.h"

namespace promenade::analysis {

// page_first.cpp: what came out.
Html stripe(const Results& results);  // nothing when all are people that count
Html headline(const Results& results);
Html flow_bar(const Selection& selection);
Html panels(const Results& results);  // dots per interface, triangle of pairs
Html buttons(const Results& results, const std::vector<DrawnFigure>& figures);

// page_figures.cpp
Html figure_section(const std::vector<DrawnFigure>& figures);

// page_notes.cpp: what it was computed from.
Html provenance_section(const Results& results, const std::vector<Section>& sections);

std::string_view page_css();  // page_css.cpp

}  // namespace promenade::analysis
