// Draws figures and their ground with OpenGL 3.3. Parts are not meshes: each is
// one quad whose fragments meet the round cone by a closed formula, with the edge
// smoothed in the shader. Needs a current context for its whole life.
#pragma once

#include <array>
#include <memory>
#include <vector>

#include "app/figure/mannequin.h"
#include "app/figure/shadow.h"
#include "app/figure/view.h"
#include "app/look.h"

namespace promenade::app {

// From the ground to the light, unit length: from the viewer's upper left.
Eigen::Vector3f key_light();
// The same for the shadow: steeper, so that it stays at the feet (ours).
Eigen::Vector3f shadow_light();

struct Ground {
  Rgb ring;
  bool dashed = false;
  Eigen::Vector2f travel = Eigen::Vector2f::Zero();  // metres walked: left, ahead
  float yaw = 0;                                     // radians, of the figure
  float stroke = 1;                                  // of its lines: 1 at 1280 x 720
};

class FigureRenderer {
 public:
  FigureRenderer();
  ~FigureRenderer();
  FigureRenderer(const FigureRenderer&) = delete;
  FigureRenderer& operator=(const FigureRenderer&) = delete;

  // Clears the whole frame.
  void begin(int width, int height, const Rgb& background);
  // Fills `view.clip` with the ground around the figure.
  void draw_ground(const View& view, const Ground& ground, const Shadow& shadow);
  void draw_parts(const View& view, const std::vector<Part>& parts, const Rgb& colour);
  // A plain rectangle; far cheaper than blending one.
  void fill(const Box& box, const Rgb& colour);

 private:
  struct Objects;
  std::unique_ptr<Objects> gl_;
  int width_ = 0, height_ = 0;
  Rgb background_ = Rgb::Ones();
};

}  // namespace promenade::app
