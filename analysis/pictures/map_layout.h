// Where things stand in a picture of dots with names: pure geometry, in pixels or any other unit.
#pragma once

#include <Eigen/Dense>
#include <optional>
#include <vector>

namespace promenade::analysis {

struct LabelSpot {
  Eigen::Vector2d at;  // the middle of the label
};

// What the labels should not leave.
struct LabelRoom {
  Eigen::Vector2d low, high;
};

// Labels of `widths` pixels and one height beside dots of a radius (2 x N, y up): of 16
// places around each dot the one that covers least of the dots and of the labels before
// it, and leaves the room least.
std::vector<LabelSpot> place_labels(const Eigen::Matrix2Xd& dots, const std::vector<double>& widths,
                                    double height, double radius, const LabelRoom& room);

// The same, but a name that would cover something or leave the room has none, and is in nobody's
// way.
std::vector<std::optional<LabelSpot>> place_labels_with_room(const Eigen::Matrix2Xd& dots,
                                                             const std::vector<double>& widths,
                                                             double height, double radius,
                                                             const LabelRoom& room);

}  // namespace promenade::analysis
