// The ground seen from above: +Z is up and +X to the left, as for somebody who walks ahead. From
// metres to pixels and back.
#pragma once

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "app/box.h"

namespace promenade::app {

// What of the ground is seen.
struct GroundSight {
  Eigen::Vector2d centre = Eigen::Vector2d::Zero();  // x, z; metres
  double across = 10;                                // metres, of the shorter side
  bool operator==(const GroundSight&) const = default;
};

inline constexpr double least_across_m = 5, most_across_m = 40;

struct GroundPlan {
  Box box;
  GroundSight sight;

  float unit() const {  // pixels in a metre
    return std::min(box.width, box.height) / static_cast<float>(sight.across);
  }
  Eigen::Vector2f pixel(const Eigen::Vector2d& at) const {
    const Eigen::Vector2f off = unit() * (at - sight.centre).cast<float>();
    return {box.middle_x() - off.x(), box.middle_y() - off.y()};
  }
  Eigen::Vector2d place(const Eigen::Vector2f& pixel) const {
    const Eigen::Vector2f off(box.middle_x() - pixel.x(), box.middle_y() - pixel.y());
    return sight.centre + (off / unit()).cast<double>();
  }
  // The nearest pixel that is seen.
  Eigen::Vector2f within(const Eigen::Vector2f& pixel) const {
    return {std::clamp(pixel.x(), box.x, box.right()), std::clamp(pixel.y(), box.y, box.bottom())};
  }
};

// So many notches nearer, with `at` staying where it is seen.
inline GroundSight zoomed(const GroundSight& sight, double notches, const Eigen::Vector2d& at) {
  const double across =
      std::clamp(sight.across * std::pow(0.8, notches), least_across_m, most_across_m);
  return {at + across / sight.across * (sight.centre - at), across};
}

}  // namespace promenade::app
