#include "app/figure/shadow.h"

#include <algorithm>
#include <cmath>

namespace promenade::app {
namespace {

struct Disc {
  float x, z, radius, strength;  // metres; optical density at the centre
};

Disc disc_of(const Eigen::Vector3f& centre, float radius, float share,
             const Eigen::Vector3f& light) {
  const float height = std::max(centre.y() - radius, 0.0f);
  const float wide = 1.35f * radius + 0.42f * height;
  const float thinning = radius * radius / (wide * wide);
  return {centre.x() - light.x() / light.y() * centre.y(),
          centre.z() - light.z() / light.y() * centre.y(), wide, 1.5f * share * thinning};
}

// Adds strength (1 - d^2/r^2)^2 to a square grid over the shadow's ground.
void add_disc(float* grid, int size, const Disc& disc) {
  const float texel = shadow_metres / static_cast<float>(size);
  const float half = 0.5f * shadow_metres;
  const auto first = [&](float at) {
    return std::max(0, static_cast<int>(std::floor((at - disc.radius + half) / texel)));
  };
  const auto last = [&](float at) {
    return std::min(size - 1, static_cast<int>(std::ceil((at + disc.radius + half) / texel)));
  };
  const float scale = 1 / (disc.radius * disc.radius);
  const int x0 = first(disc.x);
  const int x1 = last(disc.x);
  for (int row = first(disc.z); row <= last(disc.z); ++row) {
    const float dz = (static_cast<float>(row) + 0.5f) * texel - half - disc.z;
    float* line = grid + row * size;
    for (int column = x0; column <= x1; ++column) {
      const float dx = (static_cast<float>(column) + 0.5f) * texel - half - disc.x;
      const float inside = std::max(0.0f, 1.0f - (dx * dx + dz * dz) * scale);
      line[column] += disc.strength * inside * inside;
    }
  }
}

constexpr int coarse_size = 32;

// Where a fine row or column lies between two coarse ones.
struct Between {
  int first;
  float share;
};

Between coarse_place(int fine) {
  constexpr int ratio = shadow_size / coarse_size;
  const int steps = std::clamp(2 * fine + 1 - ratio, 0, 2 * ratio * (coarse_size - 1) - 1);
  const int first = steps / (2 * ratio);
  return {first, static_cast<float>(steps - 2 * ratio * first) / (2.0f * ratio)};
}

}  // namespace

void Shadow::splat(const std::vector<Part>& parts, const Eigen::Vector3f& light) {
  fine_.fill(0);
  coarse_.fill(0);
  for (const Part& part : parts) {
    if (part.tone == Tone::body) splat_part(part, light);
  }
  resolve();
}

void Shadow::splat_part(const Part& part, const Eigen::Vector3f& light) {
  const float length = (part.b - part.a).norm();
  const float thickness = part.radius_a + part.radius_b;
  const int steps = 1 + static_cast<int>(length / (0.5f * thickness));
  for (int k = 0; k <= steps; ++k) {
    const float t = static_cast<float>(k) / static_cast<float>(steps);
    const Eigen::Vector3f centre = part.a + t * (part.b - part.a);
    const float radius = part.radius_a + t * (part.radius_b - part.radius_a);
    const float share = 0.5f * (0.3f + 0.7f * part.flat);
    const Disc disc = disc_of(centre, radius, share, light);
    const bool vague = disc.radius > 0.25f;
    add_disc(vague ? coarse_.data() : fine_.data(), vague ? coarse_size : shadow_size, disc);
  }
}

void Shadow::resolve() {
  std::size_t i = 0;
  for (int row = 0; row < shadow_size; ++row) {
    const Between z = coarse_place(row);
    const float* near_line = coarse_.data() + z.first * coarse_size;
    const float* far_line = near_line + coarse_size;
    const auto mixed = [&](int x) { return near_line[x] + z.share * (far_line[x] - near_line[x]); };
    for (int column = 0; column < shadow_size; ++column) {
      const Between x = coarse_place(column);
      const float low = mixed(x.first);
      const float vague = low + x.share * (mixed(x.first + 1) - low);
      // Light that is left after the density, in the form that needs no exp.
      texels_[i] = 1 / (1 + fine_[i] + vague);
      ++i;
    }
  }
}

}  // namespace promenade::app
