// The soft shadow of a figure on the ground, splatted on the CPU: each part
// darkens a disc that widens and fades with its height, so that the shadow is
// sharp at the feet and vague under the head.
#pragma once

#include <array>
#include <vector>

#include "app/figure/mannequin.h"

namespace promenade::app {

inline constexpr int shadow_size = 128;       // texels
inline constexpr float shadow_metres = 2.6f;  // width of the square around the figure

class Shadow {
 public:
  Shadow() { texels_.fill(1); }  // of nothing
  // `light` points from the ground to the light.
  void splat(const std::vector<Part>& parts, const Eigen::Vector3f& light);
  // shadow_size^2, x along +X, then along +Z; 1 is full light.
  const std::array<float, shadow_size * shadow_size>& texels() const { return texels_; }

 private:
  void splat_part(const Part& part, const Eigen::Vector3f& light);
  void resolve();

  std::array<float, shadow_size * shadow_size> fine_{};
  std::array<float, 32 * 32> coarse_{};  // for what is high and therefore vague
  std::array<float, shadow_size * shadow_size> texels_{};
};

}  // namespace promenade::app
