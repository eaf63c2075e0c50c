// The sections of report.html, in the order in which they stand.
#pragma once

#include "analysis/report/html.h"
#include "analysis/report/page.h"

namespace promenade::analysis {

// page_first.cpp: what came out.
Html stripe(const Results& results);  // nothing when all are people that count
Html headline(const Results& results);
Html sensitivity_links(const Results& results);  // nothing where nothing could be left out
Html flow_bar(const Results& results);
Html panels(const Results& results);  // dots per interface, triangle of pairs
Html buttons();

// page_files.cpp: figures, and the files beside the page.
Html figure_section(const Results& results, const std::vector<DrawnFigure>& figures);
Html file_section(const Results& results, const std::vector<Section>& sections);

// page_notes.cpp: what it was computed from.
Html provenance_section(const Results& results);

std::string_view page_css();  // page_css.cpp

}  // namespace promenade::analysis
