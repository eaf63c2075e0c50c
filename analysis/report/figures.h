// The figures of a report, drawn by gnuplot: one style, safe for colour-blind
// readers and in grey, as SVG for the page and PDF for papers.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "analysis/results.h"

namespace promenade::analysis {

// One measure in one task: a dot per participant and interface, the dots of one
// person joined, beside them the median with its 95 % interval.
struct Figure {
  std::string name;     // of the files, without extension
  std::string caption;  // what it shows, with n
  int measure = 0;
  int task = 0;
};

// D and time for each task that has them.
std::vector<Figure> figures_of(const Results& results);

// The gnuplot script that writes NAME.svg and NAME.pdf.
std::string script_of(const Results& results, const Figure& figure);

// Draws into `folder`, which exists. Throws OutsideError.
void draw(const Results& results, const Figure& figure, const std::filesystem::path& folder);

}  // namespace promenade::analysis
