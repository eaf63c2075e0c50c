// A path over the ground as somebody draws it: corner after corner or in one stroke, in parts that
// may each want a style. No window: places are metres on the ground, x and z.
//
// Corners that were clicked are open until they are ended; a stroke ends itself. What has ended is
// wanted, and what is drawn later goes on from there.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "motion/graph/path_walk.h"
#include "study/path_csv.h"

namespace promenade::app {

struct DrawnCorner {
  Eigen::Vector2d at;  // metres
  std::string label;   // of the way that leads here; empty: any style
  int stroke = 0;      // those of one stroke are taken back together; 0: was clicked
};

struct WantedPath {
  Eigen::Matrix2Xd points;              // 2 x n (x, z), metres: through the corners
  std::vector<motion::PathPart> parts;  // where a style is wanted
  double length = 0;                    // metres
};

class PathDrawing {
 public:
  PathDrawing() = default;
  explicit PathDrawing(const study::PathTable& table);  // ended

  // The style of what is drawn from now on; empty: any.
  void choose(const std::string& label) { chosen_ = label; }
  const std::string& chosen() const { return chosen_; }

  void begin_stroke(const Eigen::Vector2d& at);
  void draw_to(const Eigen::Vector2d& at);
  void end_stroke(const Eigen::Vector2d& at);
  bool drawing() const { return drawing_; }  // a stroke

  // A corner where the last one is stays away.
  void add_corner(const Eigen::Vector2d& at);
  // False: there are no two corners.
  bool end();
  // The last corner, or the last stroke.
  void take_back();
  void clear();

  const std::vector<DrawnCorner>& corners() const { return corners_; }
  std::size_t ended() const { return ended_; }  // how many of the corners are wanted
  bool open() const { return ended_ < corners_.size(); }
  // Another number each time that something else is wanted.
  int revision() const { return revision_; }
  std::optional<WantedPath> wanted() const;  // nothing: no path yet

 private:
  bool is_last(const Eigen::Vector2d& at, double within_m) const;

  std::string chosen_;
  std::vector<DrawnCorner> corners_;
  std::size_t ended_ = 0;
  int strokes_ = 0, revision_ = 0;
  bool drawing_ = false;
};

// From corner to corner straight on, or along a smooth curve through all of them.
enum class WayThrough { straight, smooth };

// What is wanted; at least two corners.
WantedPath path_through(const std::vector<DrawnCorner>& corners,
                        WayThrough way = WayThrough::smooth);

}  // namespace promenade::app
