// Where things stand in a picture of dots with names: pure geometry, in pixels.
#pragma once

#include <Eigen/Dense>
#include <vector>

namespace promenade::analysis {

struct LabelSpot {
  Eigen::Vector2d at;  // the middle of the label
};

// Labels of `widths` pixels and one height beside dots of a radius (2 x N, y up): of eight
// places around each dot the one that covers least of the dots and of the labels before it.
std::vector<LabelSpot> place_labels(const Eigen::Matrix2Xd& dots, const std::vector<double>& widths,
                                    double height, double radius);

// Corners of the convex hull of some columns, counterclockwise; fewer than three: as
// they are.
std::vector<int> convex_hull(const Eigen::Matrix2Xd& points, std::vector<int> columns);

}  // namespace promenade::analysis
