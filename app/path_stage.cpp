#include "app/path_stage.h"

#include <algorithm>
#include <cmath>

#include "motion/graph/label_walk.h"

namespace promenade::app {
namespace {

constexpr double wander_s = 120;
constexpr double longest_step_s = 0.5;  // a pause is no walk

std::shared_ptr<const study::Stimulus> wander_of(
    const std::shared_ptr<const motion::MotionGraph>& graph) {
  const int frames = static_cast<int>(std::ceil(wander_s / graph->frame_time));
  return std::make_shared<const study::Stimulus>(
      study::make_stimulus(graph->name, graph, motion::random_walk(*graph, 1, frames)));
}

}  // namespace

PathStage::PathStage(std::shared_ptr<const motion::MotionGraph> graph)
    : level_m_(floor_level(*graph)),
      mannequin_(mannequin_of(*graph, level_m_)),
      wander_(wander_of(graph)) {
  wander();
  pose();
}

void PathStage::show(std::shared_ptr<const study::Stimulus> motion, bool whole) {
  motion_ = std::move(motion);
  whole_ = whole;
  figure_.emplace(motion_, mannequin_, level_m_);
}

void PathStage::wander() {
  if (motion_ == wander_) return;
  show(wander_, true);
  seconds_ = 0;
}

// The search keeps what it has found of the beginning of a path, pose for pose.
bool PathStage::goes_on(const study::Stimulus& motion) const {
  const int now = frame();
  if (wandering() || now >= motion.take.frames()) return false;
  const auto same = [&](int f) {
    const auto at = static_cast<std::size_t>(f);
    return motion.take.poses[at].root == motion_->take.poses[at].root;
  };
  return same(0) && same(now);
}

void PathStage::walk(std::shared_ptr<const study::Stimulus> motion, bool whole) {
  if (motion->take.frames() < 2) return;
  const bool behind = !wandering() && !whole && frame() >= motion->take.frames();
  if (behind) return;
  const double now_s = moment().seconds;
  const bool same = goes_on(*motion);
  show(std::move(motion), whole);
  seconds_ = same ? now_s : 0;
}

void PathStage::begin_again() { seconds_ = 0; }

void PathStage::advance(std::int64_t now_us) {
  const double passed_s = last_us_ < 0 ? 0 : 1e-6 * static_cast<double>(now_us - last_us_);
  last_us_ = now_us;
  if (passed_s < longest_step_s) seconds_ += passed_s;
  if (!whole_) seconds_ = std::min(seconds_, motion_->seconds());
  pose();
}

study::StimulusMoment PathStage::moment() const { return study::moment_of(*motion_, seconds_); }

int PathStage::frame() const {
  return static_cast<int>(moment().seconds / motion_->take.frame_time + 1e-6);
}

void PathStage::pose() {
  const study::StimulusMoment now = moment();
  motion::forward_kinematics(motion_->take.skeleton, figure_->pose_at(now.seconds), world_);
  place_parts(mannequin_, world_, parts_);
  turn(parts_, start_yaw + orbit_.yaw);
  shadow_.splat(parts_, shadow_light());
  const Eigen::Vector2d way = figure_->way(now);
  travel_ = (way.array() - way.array().floor()).matrix().cast<float>();
}

const std::string& PathStage::label() const {
  const int now = frame();
  for (const motion::LabelledPart& part : motion_->labels) {
    if (now < part.to) return part.label;
  }
  return motion_->labels.back().label;
}

Eigen::Vector2d PathStage::place() const {
  const motion::Take& take = motion_->take;
  const Eigen::Vector3d root = motion::pose_at(take, moment().seconds / take.frame_time).root;
  return {root.x(), root.z()};
}

Eigen::Vector2d PathStage::heading() const {
  const auto joint = [&](motion::BodyJoint one) -> Eigen::Vector3d {
    return world_.positions.col(motion_->take.body.joint[one]);
  };
  const Eigen::Vector3d left = joint(motion::left_hip) - joint(motion::right_hip);
  return Eigen::Vector2d(-left.z(), left.x()).normalized();
}

// The camera stands on the +Z of the stage, on which the world is turned.
Eigen::Vector2d PathStage::to_camera() const {
  const double yaw = start_yaw + orbit_.yaw;
  return {-std::sin(yaw), std::cos(yaw)};
}

void PathStage::draw(FigureRenderer& renderer, const Layout& layout, const Palette& palette) {
  const StagePlan plan = layout.stage_plan(false);
  const View view = make_view(orbit_, mannequin_.height, plan.figure_height,
                              {plan.figures.middle_x(), plan.foot_y}, plan.figures);
  renderer.draw_ground(view,
                       {.ring = palette.created,
                        .travel = travel_,
                        .yaw = start_yaw + orbit_.yaw,
                        .stroke = layout.scale},
                       shadow_);
  renderer.draw_parts(view, parts_, palette.created);
}

}  // namespace promenade::app
