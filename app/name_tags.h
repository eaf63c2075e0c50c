// Where names go beside the dots of a map, so that none lies on another or on a dot. One
// rule: who comes first has the room; what finds none is left out.
#pragma once

#include <Eigen/Dense>
#include <array>
#include <optional>

#include "app/box.h"

namespace promenade::app {

class NameTags {
 public:
  explicit NameTags(const Box& area) : area_(area) {}

  // A dot, or something else that no name may lie on.
  void keep_free(const Box& box);
  // For a name of this size beside a dot; the box is taken from now on. Nothing: no room.
  std::optional<Box> place(const Eigen::Vector2f& dot, float radius, const Eigen::Vector2f& size);
  // The same, on other names if it must be, but never outside the area.
  Box place_anyway(const Eigen::Vector2f& dot, float radius, const Eigen::Vector2f& size) const;

 private:
  bool is_free(const Box& box) const;

  Box area_;
  std::array<Box, 512> taken_{};  // more are not drawn
  std::size_t count_ = 0;
};

}  // namespace promenade::app
