// Draws the window in which a path is drawn, and says what was done in it: the ground from above,
// the styles, how far the search is, and the buttons. The figure is drawn by its PathStage, under
// what is drawn here.
#pragma once

#include <functional>
#include <optional>
#include <string>

#include "app/path_picture.h"
#include "app/path_stage.h"
#include "app/path_worker.h"
#include "app/tool_page.h"

namespace promenade::app {

// What the view shows and works on. All outlive it.
struct PathScene {
  const motion::MotionGraph& graph;
  PathDrawing& drawing;
  PathWorker& worker;
  PathStage& stage;
};

// Every text that the view can show.
std::vector<std::string> shown_words(const motion::MotionGraph& graph);

class PathView {
 public:
  // `save`: writes a motion, and throws InputError or OutsideError; empty: there is no Save.
  PathView(const PathScene& scene, Gui& gui, InputQueue& queue,
           std::function<void(const motion::Take&)> save);

  // Draws until nothing waits in the queue.
  void frame();
  const WidgetMap& widgets() const { return page_.widgets(); }
  const GroundSight& sight() const { return sight_; }
  const std::shared_ptr<const WalkedPath>& walked() const { return walked_; }  // null: nothing yet
  std::string words() const;  // what stands below the styles
  const Focus& focus() const { return page_.focus(); }

 private:
  void follow();
  void ask();
  void draw(const Ui& ui);
  void draw_head(const Ui& ui) const;
  void draw_stage(const Ui& ui);
  void draw_plane(const Ui& ui, const Box& box);
  void draw_picture(const Ui& ui, const GroundPlan& plan, const PlaneTouch& touch) const;
  std::vector<Box> label_boxes(const Ui& ui, float width) const;
  float draw_labels(const Ui& ui, const Box& box);  // the height that they take
  void draw_label(const Ui& ui, const Box& box, std::size_t k);
  void draw_state(const Ui& ui, const Box& box);
  void draw_progress(const Ui& ui, const Box& box);
  void draw_foot(const Ui& ui);
  void use_mouse(const Ui& ui, const GroundPlan& plan, const PlaneTouch& touch);
  void press(const Eigen::Vector2f& at);
  void drag(const GroundPlan& plan, const Eigen::Vector2f& at, float least);
  void release(const Eigen::Vector2d& at);
  void use_keys(const GroundPlan& plan);
  void move_cursor(const GroundPlan& plan, double right, double up);
  void set_corner();
  void take_back();
  void choose(std::size_t k);
  void choose_by_key(const Ui& ui);
  void save();
  std::vector<DrawnCorner> corners_in_sight(const GroundPlan& plan, const PlaneTouch& touch) const;

  PathScene scene_;
  Gui& gui_;
  ToolPage page_;
  std::function<void(const motion::Take&)> save_;
  StyleColours colours_;
  std::vector<std::string> choices_;  // any style, and those of the graph
  GroundSight sight_;
  Eigen::Vector2d cursor_ = Eigen::Vector2d::Zero();  // of the keyboard, metres
  std::optional<Eigen::Vector2f> pressed_at_;         // pixels, while the button is down
  int revision_ = -1;                                 // of what the worker was asked for
  std::optional<WantedPath> wanted_;
  std::shared_ptr<const WalkedPath> walked_;
  WalkedWay way_;
  SaveReport saved_;  // the last time; no words: not since another walk was found
};

}  // namespace promenade::app
