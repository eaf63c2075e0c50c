// The figure that walks a drawn path: over a ground that goes by under it, as seen from a camera
// that goes with it and keeps its direction. Until there is a path it wanders through its graph.
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "app/figure/renderer.h"
#include "app/layout.h"
#include "app/stimulus_stage.h"

namespace promenade::app {

class PathStage {
 public:
  explicit PathStage(std::shared_ptr<const motion::MotionGraph> graph);

  // From now on it walks this. Where it is the same up to this moment the figure goes on, else it
  // begins. What is not `whole` is still being searched: the figure waits at its end, and as long
  // as it is no further than the figure, the walk before goes on.
  void walk(std::shared_ptr<const study::Stimulus> motion, bool whole);
  void wander();
  void begin_again();
  bool wandering() const { return motion_ == wander_; }

  void advance(std::int64_t now_us);
  // The figure as it is at this moment.
  void pose();
  void draw(FigureRenderer& renderer, const Layout& layout, const Palette& palette);

  const study::Stimulus& motion() const { return *motion_; }
  double seconds() const { return seconds_; }  // of the motion, with all its rounds
  const std::string& label() const;            // of what is seen
  Eigen::Vector2d place() const;               // of the pelvis in the world of the path: x, z
  Eigen::Vector2d heading() const;             // where its hips face there, length 1
  // From the figure to the camera, in the world of the path; length 1.
  Eigen::Vector2d to_camera() const;
  Orbit& orbit() { return orbit_; }
  // What is drawn: metres, about its spot.
  const std::vector<Part>& parts() const { return parts_; }

 private:
  study::StimulusMoment moment() const;
  int frame() const;
  void show(std::shared_ptr<const study::Stimulus> motion, bool whole);
  bool goes_on(const study::Stimulus& motion) const;

  double level_m_;
  Mannequin mannequin_;
  std::shared_ptr<const study::Stimulus> wander_, motion_;
  std::optional<StimulusFigure> figure_;  // of motion_
  bool whole_ = true;
  double seconds_ = 0;
  std::int64_t last_us_ = -1;
  Orbit orbit_;
  motion::WorldPose world_;
  std::vector<Part> parts_;
  Shadow shadow_;
  Eigen::Vector2f travel_ = Eigen::Vector2f::Zero();  // metres
};

}  // namespace promenade::app
