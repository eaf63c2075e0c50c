// A path over the ground as people write it: a table with columns x and z (metres), and perhaps
// label, the style that is wanted from that point on. A path has up to a kilometre.
#pragma once

#include <Eigen/Dense>
#include <string>
#include <string_view>
#include <vector>

#include "motion/place.h"

namespace promenade::study {

struct PathTable {
  Eigen::Matrix2Xd points;          // x, z
  std::vector<std::string> labels;  // one for each point; empty: any style
  std::vector<Place> places;        // of the labels, in the table
};

// Throws InputError with all problems and their places in `file`.
PathTable parse_path(std::string_view text, const std::string& file);

}  // namespace promenade::study
