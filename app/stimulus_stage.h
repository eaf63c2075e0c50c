// Stimuli on the stage. A stimulus walks over the ground and may turn; the camera goes with it: it
// keeps its place on screen and its direction in the world. All of this is a function of the
// moment, so that a replay shows what was shown.
#pragma once

#include <map>

#include "app/figure/mannequin.h"
#include "study/stimulus.h"

namespace promenade::app {

using StimulusList = std::vector<std::shared_ptr<const study::Stimulus>>;

class StimulusFigure {
 public:
  // `level_m`: how much higher its floor is than the ground.
  StimulusFigure(std::shared_ptr<const study::Stimulus> stimulus, const Mannequin& mannequin,
                 double level_m);

  const Mannequin& mannequin() const { return mannequin_; }
  // With the camera over the origin: `seconds` of the motion, 0 to its length.
  motion::Pose pose_at(double seconds) const;
  // Left and ahead, metres: how far the camera has gone. It goes on from where a round ended, so
  // that the ground does not jump when the motion begins again.
  Eigen::Vector2d way(const study::StimulusMoment& moment) const;

 private:
  Eigen::Vector2d camera_at(double seconds) const;

  std::shared_ptr<const study::Stimulus> stimulus_;
  Mannequin mannequin_;
  double level_m_;
  Eigen::Matrix2Xd camera_;  // x, z of each frame: the way of the pelvis without its sway
};

// All stimuli of a study, each made when this is.
class StimulusFigures {
 public:
  // `skeleton`, `mannequin`: of the motion set. A graph with other bones has a figure of its own.
  StimulusFigures(const StimulusList& stimuli, const motion::Skeleton& skeleton,
                  const Mannequin& mannequin);
  const StimulusFigure& of(const study::Stimulus& stimulus) const;  // one of these

 private:
  std::map<const study::Stimulus*, StimulusFigure> figures_;
};

// How much higher the takes of a graph (or one take) stand than figures do, metres; and a figure
// made to their measure, with the ground under its feet.
double floor_level(const motion::MotionGraph& graph);
double floor_level(const motion::Take& take);
Mannequin mannequin_of(const motion::MotionGraph& graph, double level_m);
Mannequin mannequin_of(const motion::Take& take, double level_m);

// The way of the pelvis over the ground (2 x T: x, z; metres) without how it sways with the
// steps: a straight line fitted around each frame, the near ones weighing most.
Eigen::Matrix2Xd smooth_way(const motion::Take& take);

}  // namespace promenade::app
