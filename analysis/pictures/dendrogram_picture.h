// The dendrogram behind sliders, drawn by gnuplot: which pairs of adjectives, or features, were
// put together at which cost, where the tree was cut, and what was left out.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "motion/models/ward.h"

namespace promenade::analysis {

struct DendrogramPicture {
  std::string title;                  // above it
  std::vector<std::string> warnings;  // in red below the title: simulated raters
  motion::Dendrogram tree;
  std::vector<std::string> leaves;   // n
  std::vector<int> cluster;          // n, 0 to C-1
  std::vector<std::string> names;    // C
  std::vector<std::string> dropped;  // below: what, and why
};

// Writes FILE.svg, FILE.pdf or FILE.png, by its ending. Throws InputError for another ending,
// OutsideError when gnuplot or the disk refuses.
void draw_dendrogram(const DendrogramPicture& picture, const std::filesystem::path& file);

}  // namespace promenade::analysis
