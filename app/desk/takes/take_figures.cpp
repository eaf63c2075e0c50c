#include "app/desk/takes/take_figures.h"

#include <algorithm>
#include <cmath>

#include "app/stimulus_stage.h"

namespace promenade::app {
namespace {

Eigen::Vector2f within_metre(const Eigen::Vector2d& way) {
  return (way.array() - way.array().floor()).matrix().cast<float>();
}

}  // namespace

TakeFigure::TakeFigure(std::shared_ptr<const motion::TakeReview> review)
    : review_(std::move(review)),
      level_m_(floor_level(review_->take)),
      mannequin_(mannequin_of(review_->take, level_m_)),
      camera_(review_->take.frames() > 1 ? smooth_way(review_->take)
                                         : motion::pelvis_way(review_->take)) {
  const Eigen::Vector2d& heading = review_->figure.heading;
  ahead_ = Eigen::AngleAxisd(-std::atan2(heading.x(), heading.y()), Eigen::Vector3d::UnitY());
}

void TakeFigure::pose(double frame, float yaw, FigureMoment& moment) const {
  const motion::Take& take = review_->take;
  const auto last = camera_.cols() - 1;
  const auto before = std::clamp(static_cast<Eigen::Index>(frame), Eigen::Index{0},
                                 std::max(last - 1, Eigen::Index{0}));
  const double share = std::clamp(frame - static_cast<double>(before), 0.0, 1.0);
  const Eigen::Vector2d camera =
      (1 - share) * camera_.col(before) + share * camera_.col(std::min(before + 1, last));
  motion::Pose pose = motion::pose_at(take, frame);
  pose.root = ahead_ * (pose.root - Eigen::Vector3d(camera.x(), level_m_, camera.y()));
  pose.rotations.front() = ahead_ * pose.rotations.front();
  place_parts(mannequin_, motion::forward_kinematics(take.skeleton, pose), moment.parts);
  turn(moment.parts, yaw);
  moment.shadow.splat(moment.parts, shadow_light());
  const Eigen::Vector2d way = camera - camera_.col(0);
  const Eigen::Vector3d turned = ahead_ * Eigen::Vector3d(way.x(), 0, way.y());
  moment.travel = within_metre({turned.x(), turned.z()});
}

LoopFigure::LoopFigure(std::shared_ptr<const motion::LoopReview> loop)
    : loop_(std::move(loop)), mannequin_(make_mannequin(loop_->set)) {}

void LoopFigure::parts(double seconds, float yaw, std::vector<Part>& parts) const {
  const motion::Cycle& cycle = loop_->cycle();
  const double phase = motion::phase_at(loop_->set, cycle, seconds);
  const motion::Pose pose = motion::pose_at(loop_->set, cycle, phase);
  place_parts(mannequin_, motion::forward_kinematics(loop_->set.skeleton, pose), parts);
  turn(parts, yaw);
}

void LoopFigure::pose(double seconds, float yaw, FigureMoment& moment) const {
  parts(seconds, yaw, moment.parts);
  moment.shadow.splat(moment.parts, shadow_light());
  moment.travel = within_metre(seconds * loop_->cycle().velocity);
}

}  // namespace promenade::app
