// Draws the minimap: the known region, the clusters, dots, bookmarks, names and the point.
#pragma once

#include "app/minimap.h"
#include "app/panel.h"

namespace promenade::app {

// Where the plane lies on screen.
struct Chart {
  Box box;
  Eigen::Vector2f zero;  // the pixel of (0, 0)
  float unit;            // pixels of 1, to the right and up

  Eigen::Vector2f pixel(const Eigen::Vector2d& point) const {
    return {zero.x() + unit * static_cast<float>(point.x()),
            zero.y() - unit * static_cast<float>(point.y())};
  }
  Eigen::Vector2d point(const Eigen::Vector2f& pixel) const {
    return {(pixel.x() - zero.x()) / unit, (zero.y() - pixel.y()) / unit};
  }
  bool holds(const Eigen::Vector2f& pixel) const { return box.holds(pixel.x(), pixel.y()); }
};

Chart chart_of(const MinimapState& state, const Box& box);

// The item within `reach` pixels of a place; of several the nearest, bookmarks first.
Item item_at(const MinimapState& state, const Chart& chart, const Eigen::Vector2f& at, float reach);

// Everything but what can be pressed. `hovered`: the item under the pointer.
void draw_chart(const MinimapState& state, const Chart& chart, study::InterfacePanel& panel,
                const Item& hovered);

}  // namespace promenade::app
