// What the graphics card is told about one part: the quad that covers it on
// screen, and the part's own space.
#pragma once

#include "app/figure/mannequin.h"
#include "app/figure/view.h"

namespace promenade::app {

// In the order of the shader's attributes; all floats.
struct PartQuad {
  Eigen::Vector2f middle, along, aside;  // pixels: centre and half sides
  Eigen::Vector3f row_x, row_y, row_z;   // world direction to the part's own space
  Eigen::Vector3f eye;                   // in the part's own space
  Eigen::Vector3f shape;                 // length, radius at 0, radius at the end
  Eigen::Vector3f colour;                // linear light
};

PartQuad make_quad(const View& view, const Part& part, const Eigen::Vector3f& linear_colour);

// Farthest first, so that smoothed edges mix with what is behind them.
void sort_by_depth(const View& view, std::vector<Part>& parts);

}  // namespace promenade::app
