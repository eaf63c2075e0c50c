#include "app/figure/part_quad.h"

#include <algorithm>
#include <cmath>

namespace promenade::app {
namespace {

// Half the size of a sphere's picture. Away from the optical axis it is an
// ellipse, longer by less than the factor here for the fields of view in use.
float picture_radius(const View& view, const Eigen::Vector3f& centre, float radius) {
  return 1.04f * radius * view.focal / (view.depth(centre) - radius) + 1;
}

// The axis must be long enough to have a direction and longer than the radii
// differ, else one sphere holds the other.
float safe_length(const Part& part, float length) {
  return std::max({length, 1.02f * std::abs(part.radius_a - part.radius_b), 1e-4f});
}

}  // namespace

PartQuad make_quad(const View& view, const Part& part, const Eigen::Vector3f& linear_colour) {
  PartQuad quad;
  const Eigen::Vector3f axis = (part.b - part.a).normalized();
  quad.row_x = part.thin / part.flat;
  quad.row_y = axis;
  quad.row_z = part.thin.cross(axis);
  const Eigen::Vector3f from = view.eye - part.a;
  quad.eye = {quad.row_x.dot(from), quad.row_y.dot(from), quad.row_z.dot(from)};
  quad.shape = {safe_length(part, (part.b - part.a).norm()), part.radius_a, part.radius_b};
  quad.colour = part.tone == Tone::joint ? Eigen::Vector3f(0.45f * linear_colour) : linear_colour;

  const Eigen::Vector2f a = view.pixel(part.a);
  const Eigen::Vector2f b = view.pixel(part.b);
  const float ra = picture_radius(view, part.a, part.radius_a);
  const float rb = picture_radius(view, part.b, part.radius_b);
  const float distance = (b - a).norm();
  const Eigen::Vector2f along =
      distance > 1e-3f ? Eigen::Vector2f((b - a) / distance) : Eigen::Vector2f(1, 0);
  const float low = std::min(-ra, distance - rb);
  const float high = std::max(ra, distance + rb);
  quad.middle = a + 0.5f * (low + high) * along;
  quad.along = 0.5f * (high - low) * along;
  quad.aside = std::max(ra, rb) * Eigen::Vector2f(-along.y(), along.x());
  return quad;
}

void sort_by_depth(const View& view, std::vector<Part>& parts) {
  const auto depth = [&](const Part& part) { return view.depth(0.5f * (part.a + part.b)); };
  std::sort(parts.begin(), parts.end(),
            [&](const Part& one, const Part& other) { return depth(one) > depth(other); });
}

}  // namespace promenade::app
