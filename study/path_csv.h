// A path over the ground as people write it: a table with columns x and z (metres), and perhaps
// label, the style that is wanted from that point on.
#pragma once

#include <Eigen/Dense>
#include <string>
#include <string_view>
#include <vector>

namespace promenade::study {

struct PathTable {
  Eigen::Matrix2Xd points;          // x, z
  std::vector<std::string> labels;  // one for each point; empty: any style
};

// Throws InputError with all problems and their places in `file`.
PathTable parse_path(std::string_view text, const std::string& file);

}  // namespace promenade::study
