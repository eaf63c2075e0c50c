#include "app/figure/view.h"

#include <cmath>

namespace promenade::app {

Eigen::Vector2f View::pixel(const Eigen::Vector3f& point) const {
  const Eigen::Vector3f seen = point - eye;
  const float scale = focal / seen.dot(ahead);
  return centre + Eigen::Vector2f(scale * seen.dot(right), -scale * seen.dot(up));
}

Eigen::Vector3f View::ray(const Eigen::Vector2f& at) const {
  return focal * ahead + (at.x() - centre.x()) * right - (at.y() - centre.y()) * up;
}

View make_view(const Orbit& orbit, double height, float pixels, const Eigen::Vector2f& foot,
               const Box& clip) {
  View view;
  const float pitch = start_pitch + orbit.pitch;
  view.ahead = Eigen::Vector3f(0, -std::sin(pitch), -std::cos(pitch));
  view.right = Eigen::Vector3f::UnitX();
  view.up = view.right.cross(view.ahead);
  const float middle = 0.5f * static_cast<float>(height);
  view.eye = Eigen::Vector3f(0, middle, 0) - camera_distance * view.ahead;
  view.focal = pixels * camera_distance / static_cast<float>(height) / std::cos(start_pitch);
  // The middle of the figure keeps its place whatever is turned.
  view.centre = foot - Eigen::Vector2f(0, 0.5f * pixels);
  view.focal *= orbit.zoom;
  view.centre += view.focal / camera_distance * Eigen::Vector2f(orbit.right, -orbit.up);
  view.clip = clip;
  return view;
}

}  // namespace promenade::app
