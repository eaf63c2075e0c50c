// The figures of takes and of their loops: who walks at which moment, over its spot.
#pragma once

#include <memory>

#include "app/figure/renderer.h"
#include "motion/take_review.h"

namespace promenade::app {

// A figure at one moment, over the origin; it walks along +Z.
struct FigureMoment {
  std::vector<Part> parts;
  Shadow shadow;
  Eigen::Vector2f travel = Eigen::Vector2f::Zero();  // metres: left, ahead
};

// Who walks through a whole take. The camera goes with it, so that it keeps its spot.
class TakeFigure {
 public:
  explicit TakeFigure(std::shared_ptr<const motion::TakeReview> review);
  const motion::TakeReview& review() const { return *review_; }
  double height() const { return mannequin_.height; }
  void pose(double frame, float yaw, FigureMoment& moment) const;

 private:
  std::shared_ptr<const motion::TakeReview> review_;
  double level_m_;
  Mannequin mannequin_;
  Eigen::Matrix2Xd camera_;   // x, z of each frame
  Eigen::Quaterniond ahead_;  // brings its heading to +Z
};

// Who walks a loop on and on.
class LoopFigure {
 public:
  explicit LoopFigure(std::shared_ptr<const motion::LoopReview> loop);
  const motion::LoopReview& loop() const { return *loop_; }
  double height() const { return mannequin_.height; }
  double seconds() const { return loop_->cycle().seconds; }
  void parts(double seconds, float yaw, std::vector<Part>& parts) const;
  void pose(double seconds, float yaw, FigureMoment& moment) const;

 private:
  std::shared_ptr<const motion::LoopReview> loop_;
  Mannequin mannequin_;
};

}  // namespace promenade::app
