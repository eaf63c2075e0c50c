// How a trial went, beside how it ended: the same measures for every interface, because they
// are taken from what was shown (weights, poses) and from the kind of input alone. All are
// columns of table `trial` and described in `dictionary`. Pauses do not count. (ours)
#pragma once

#include <bitset>
#include <cstdint>
#include <optional>
#include <vector>

#include "motion/distance.h"
#include "motion/motion_space.h"

namespace promenade::study {

struct ProcessMeasures {
  std::optional<double> d_area_m_s;  // area under D over the time worked; null without D
  double path_m = 0;                 // sum of D between each shown state and the next
  int reversals = 0;         // gestures that went back: at more than 90 degrees to the one before
  int drags = 0;             // gestures of more than one input
  int controls_touched = 0;  // different ones
  int examples_visited = 0;  // different examples that were shown as they are
  double map_coverage = 0;   // share of the cells of a 10 x 10 map that were visited, 0 to 1
  std::int64_t idle_us = 0;  // in rests of more than two seconds without any input
  int camera_moves = 0;      // gestures of the camera
};

// The plane of the first two principal components, over the examples of a set: what coverage
// is counted on, whatever the interface. A set without spread has a map of one cell.
struct CoverageMap {
  Eigen::MatrixX2d examples;                          // N x 2
  Eigen::RowVector2d least, cell;                     // of the 10 x 10 cells around them
  int cell_of(const Eigen::VectorXd& weights) const;  // 0 to 99; beyond the edge: -1
};
CoverageMap make_coverage_map(const motion::MotionSpace& space);

// Fed by the session while a trial runs; `t_us` is the time worked in the trial.
class ProcessMeter {
 public:
  void begin(std::int64_t t_us);
  // Something new is shown. `d`: nothing without a target motion; `way_m`: D from what was
  // shown before; `changed`: by a gesture that had not changed anything before.
  void shown(std::int64_t t_us, std::optional<double> d, double way_m,
             const Eigen::VectorXd& weights, const CoverageMap& map, bool changed);
  void input(std::int64_t t_us);  // anything that the participant did
  void drag() { ++measures_.drags; }
  void camera(std::int64_t t_us);
  void touched(int controls) { measures_.controls_touched = controls; }
  ProcessMeasures at(std::int64_t t_us) const;  // as if the trial ended then

 private:
  void visit(const Eigen::VectorXd& weights, const CoverageMap& map);
  void turn();  // a gesture is over

  ProcessMeasures measures_;
  std::int64_t shown_us_ = 0, input_us_ = 0, camera_us_ = -1;
  std::optional<double> d_;
  Eigen::VectorXd weights_, turned_;  // shown now; where the last gesture began
  Eigen::VectorXd direction_;         // of the gesture before
  std::bitset<100> cells_;
  std::vector<bool> examples_;
};

}  // namespace promenade::study
