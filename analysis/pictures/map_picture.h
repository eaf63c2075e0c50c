// Pictures of a minimap, drawn by gnuplot: the map with its clusters ([N] Figure 5.8), and
// one map point under each heuristic, as a strip of walking figures ([N] Figure 5.9).
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "motion/models/map.h"
#include "motion/motion_space.h"

namespace promenade::analysis {

struct MapPicture {
  std::string title;               // above it
  std::vector<std::string> names;  // N, beside the dots
  std::vector<int> clusters;       // N, from 0: colours and outlines
  motion::Minimap map;
};

// What one heuristic makes of the point.
struct HeuristicStrip {
  std::string heuristic;           // "zero"
  std::vector<std::string> notes;  // lines under it: the nearest example
  Eigen::VectorXd weights;         // N, sum 1
};

// Write FILE.svg, FILE.pdf or FILE.png, by its ending. Throw InputError for another
// ending, OutsideError when gnuplot or the disk refuses.
void draw_map(const MapPicture& picture, const std::filesystem::path& file);
void draw_heuristics(const MapPicture& picture, const motion::MotionSpace& space,
                     const Eigen::Vector2d& point, const std::vector<HeuristicStrip>& strips,
                     const std::filesystem::path& file);

}  // namespace promenade::analysis
