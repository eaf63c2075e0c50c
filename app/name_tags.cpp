#include "app/name_tags.h"

#include <algorithm>

namespace promenade::app {
namespace {

bool overlap(const Box& a, const Box& b) {
  return a.x < b.right() && b.x < a.right() && a.y < b.bottom() && b.y < a.bottom();
}

// Where a name may stand, in steps of its size from the dot: right, left, above, below, and
// the corners.
constexpr std::array<std::array<float, 2>, 8> sides = {
    {{1, 0}, {-1, 0}, {0, -1}, {0, 1}, {1, -1}, {1, 1}, {-1, -1}, {-1, 1}}};

Box beside(const Eigen::Vector2f& dot, float radius, const Eigen::Vector2f& size,
           const std::array<float, 2>& side) {
  const bool corner = side[0] != 0 && side[1] != 0;
  const float out = corner ? 0.5f * radius : radius;
  const float x = dot.x() + side[0] * (out + 0.5f * size.x()) - 0.5f * size.x();
  const float y = dot.y() + side[1] * (out + 0.5f * size.y()) - 0.5f * size.y();
  return {x, y, size.x(), size.y()};
}

}  // namespace

void NameTags::keep_free(const Box& box) {
  if (count_ < taken_.size()) taken_[count_++] = box;
}

bool NameTags::is_free(const Box& box) const {
  const bool inside = box.x >= area_.x && box.right() <= area_.right() && box.y >= area_.y &&
                      box.bottom() <= area_.bottom();
  return inside && std::none_of(taken_.begin(), taken_.begin() + static_cast<long>(count_),
                                [&](const Box& other) { return overlap(box, other); });
}

std::optional<Box> NameTags::place(const Eigen::Vector2f& dot, float radius,
                                   const Eigen::Vector2f& size) {
  if (count_ == taken_.size()) return std::nullopt;
  for (const auto& side : sides) {
    const Box box = beside(dot, radius, size, side);
    if (!is_free(box)) continue;
    keep_free(box);
    return box;
  }
  return std::nullopt;
}

Box NameTags::place_anyway(const Eigen::Vector2f& dot, float radius,
                           const Eigen::Vector2f& size) const {
  Box box = beside(dot, radius, size, sides[0]);
  if (box.right() > area_.right()) box = beside(dot, radius, size, sides[1]);
  box.x = std::max(area_.x, std::min(box.x, area_.right() - box.width));
  box.y = std::max(area_.y, std::min(box.y, area_.bottom() - box.height));
  return box;
}

}  // namespace promenade::app
