// From metres to pixels: a pinhole camera that looks at a figure standing at the
// origin. Both figures of a trial are seen by the same camera, each drawn about
// its own spot of the window, so that their pictures can be compared.
#pragma once

#include <Eigen/Dense>

#include "app/box.h"

namespace promenade::app {

// What the participant turns: the figure on its spot, and how it is looked at.
struct Orbit {
  float yaw = 0;    // radians, of the figure; 0: the three-quarter view of the start
  float pitch = 0;  // radians, added to the start's
  float zoom = 1;
  float right = 0, up = 0;  // metres that the picture was moved

  bool operator==(const Orbit&) const = default;
};

inline constexpr float start_yaw = 0.62f;       // the figure faces right of the viewer
inline constexpr float start_pitch = 0.16f;     // looked at from slightly above
inline constexpr float camera_distance = 8.5f;  // metres

struct View {
  Eigen::Vector3f eye, right, up, ahead;  // metres; unit vectors
  Eigen::Vector2f centre;                 // pixels, y down: where the point looked at is seen
  float focal = 1;                        // pixels
  Box clip;                               // nothing is drawn outside

  Eigen::Vector2f pixel(const Eigen::Vector3f& point) const;
  float depth(const Eigen::Vector3f& point) const { return (point - eye).dot(ahead); }
  // Through the middle of a pixel; not of unit length: its depth is `focal`.
  Eigen::Vector3f ray(const Eigen::Vector2f& pixel) const;
};

// Sees a figure of `height` metres `pixels` tall, with its feet `foot` on screen.
View make_view(const Orbit& orbit, double height, float pixels, const Eigen::Vector2f& foot,
               const Box& clip);

}  // namespace promenade::app
