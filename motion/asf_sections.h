// An Acclaim skeleton file section by section, before its bones hang together.
// Internal to the reader.
#pragma once

#include <array>

#include "motion/clip.h"
#include "motion/scanner.h"

namespace promenade::motion {

// Three turns about fixed axes, the first one first.
struct AsfTurns {
  std::array<int, 3> axis = {0, 1, 2};
  std::array<double, 3> angle = {};  // as the file writes them
};

struct AsfBone {
  std::string name;
  std::size_t place = 0;  // of its name in the text
  Eigen::Vector3d direction = Eigen::Vector3d::Zero();
  double length = 0;
  AsfTurns axis;
  std::vector<Channel> channels;
};

// One line of the hierarchy.
struct AsfFamily {
  std::string_view parent;
  std::vector<std::string_view> children;
  std::vector<std::size_t> places;  // of the children in the text
  std::size_t place = 0;            // of the parent
};

struct AsfSections {
  double length = 0;  // 0: not stated
  bool radians = false;
  std::vector<Channel> root_order;
  AsfTurns root_orientation;
  Eigen::Vector3d root_position = Eigen::Vector3d::Zero();
  std::vector<AsfBone> bones;
  std::vector<AsfFamily> families;
};

// Gives up at the first thing that it cannot make sense of.
AsfSections read_asf_sections(Scanner& in);

}  // namespace promenade::motion
