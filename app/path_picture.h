// Draws the ground from above for the window in which a path is drawn: the grid, the wanted path,
// the walked way in the colours of its styles, and where the figure is.
#pragma once

#include "app/ground_plan.h"
#include "app/path_drawing.h"
#include "app/widgets.h"
#include "motion/graph/graph_walk.h"

namespace promenade::app {

// Each style has the colour that it has in pictures of the graph.
class StyleColours {
 public:
  explicit StyleColours(const motion::MotionGraph& graph);
  // The styles that somebody can walk in, sorted.
  const std::vector<std::string>& labels() const { return labels_; }
  Rgb of(const std::string& label) const;  // empty: any style

 private:
  std::vector<std::string> all_, labels_;
};

struct WalkedWay {
  Eigen::Matrix2Xd way;  // of the pelvis, each frame; x, z, metres
  std::vector<motion::LabelledPart> labels;
};

class PathPicture {
 public:
  PathPicture(const Ui& ui, const GroundPlan& plan, const StyleColours& colours)
      : ui_(ui), plan_(plan), colours_(colours) {}

  void draw_grid() const;
  void draw_wanted(const WantedPath& path) const;
  void draw_walked(const WalkedWay& walked) const;
  void draw_corner(const Eigen::Vector2d& at, const std::string& label) const;
  void draw_walker(const Eigen::Vector2d& at, const Eigen::Vector2d& heading) const;
  void draw_camera(const Eigen::Vector2d& to_camera) const;
  void draw_cursor(const Eigen::Vector2d& at) const;
  void draw_scale() const;

 private:
  ImVec2 pixel(const Eigen::Vector2d& at) const;
  void draw_line(const Eigen::Vector2d& from, const Eigen::Vector2d& to, const Rgb& colour) const;
  Rgb wanted_colour(const std::string& label) const;

  const Ui& ui_;
  const GroundPlan& plan_;
  const StyleColours& colours_;
};

// Metres between the lines of the grid.
double grid_step(const GroundPlan& plan, float least_pixels);

}  // namespace promenade::app
