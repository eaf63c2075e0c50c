#include "app/stimulus_stage.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "motion/foot_measures.h"
#include "motion/quantile.h"

namespace promenade::app {
namespace {

constexpr double smoothing_s =
    0.4;  // standard deviation of the weights; a step takes half a second
constexpr double between_looks_s = 0.1;

using Takes = std::vector<const motion::Take*>;  // of one skeleton, at least one

Takes takes_of(const motion::MotionGraph& graph) {
  Takes takes;
  for (const motion::GraphTake& one : graph.takes) takes.push_back(&one.take);
  return takes;
}

// Every tenth of a second of all takes.
template <typename Look>
void look_at(const Takes& takes, const Look& look) {
  for (const motion::Take* take : takes) {
    const int step = std::max(1, static_cast<int>(std::lround(between_looks_s / take->frame_time)));
    for (int f = 0; f < take->frames(); f += step) look(take->poses[static_cast<std::size_t>(f)]);
  }
}

// Turned so that the hips face +Z.
motion::Pose facing_ahead(const motion::Take& take, motion::Pose pose) {
  const motion::WorldPose world = motion::forward_kinematics(take.skeleton, pose);
  const Eigen::Vector3d left = world.positions.col(take.body.joint[motion::left_hip]) -
                               world.positions.col(take.body.joint[motion::right_hip]);
  const Eigen::Quaterniond turn(
      Eigen::AngleAxisd(std::atan2(left.z(), left.x()), Eigen::Vector3d::UnitY()));
  pose.root = turn * pose.root;
  pose.rotations.front() = turn * pose.rotations.front();
  return pose;
}

Eigen::Vector2d pelvis_at(const motion::Take& take, int frame) {
  const Eigen::Vector3d& root = take.poses[static_cast<std::size_t>(frame)].root;
  return {root.x(), root.z()};
}

// The value at `frame` of the line that fits best around it.
Eigen::Vector2d fitted_at(const motion::Take& take, int frame) {
  const double width = smoothing_s / take.frame_time;
  const int reach = static_cast<int>(std::ceil(3 * width));
  double s0 = 0, s1 = 0, s2 = 0;
  Eigen::Vector2d sum = Eigen::Vector2d::Zero(), moment = Eigen::Vector2d::Zero();
  for (int f = std::max(0, frame - reach); f <= std::min(take.frames() - 1, frame + reach); ++f) {
    const double away = f - frame;
    const double weight = std::exp(-0.5 * away * away / (width * width));
    s0 += weight;
    s1 += weight * away;
    s2 += weight * away * away;
    sum += weight * pelvis_at(take, f);
    moment += weight * away * pelvis_at(take, f);
  }
  return (s2 * sum - s1 * moment) / (s0 * s2 - s1 * s1);
}

double floor_level(const Takes& takes) {
  const motion::Take& any = *takes.front();
  std::vector<double> heights;
  motion::WorldPose world;
  look_at(takes, [&](const motion::Pose& pose) {
    motion::forward_kinematics(any.skeleton, pose, world);
    const auto height = [&](motion::BodyJoint toe) {
      return world.positions(1, any.body.joint[toe]);
    };
    heights.push_back(std::min(height(motion::left_toe), height(motion::right_toe)));
  });
  const double level = motion::quantile(std::move(heights), 0.05);
  return level - motion::floor_level(level);
}

Mannequin mannequin_of(const Takes& takes, double level_m) {
  const motion::Take& any = *takes.front();
  std::vector<motion::WorldPose> poses;
  look_at(takes, [&](const motion::Pose& pose) {
    motion::Pose ahead = facing_ahead(any, pose);
    ahead.root.y() -= level_m;
    poses.push_back(motion::forward_kinematics(any.skeleton, ahead));
  });
  return make_mannequin(any.skeleton, any.body, poses);
}

}  // namespace

double floor_level(const motion::MotionGraph& graph) { return floor_level(takes_of(graph)); }

double floor_level(const motion::Take& take) { return floor_level(Takes{&take}); }

Mannequin mannequin_of(const motion::MotionGraph& graph, double level_m) {
  return mannequin_of(takes_of(graph), level_m);
}

Mannequin mannequin_of(const motion::Take& take, double level_m) {
  return mannequin_of(Takes{&take}, level_m);
}

Eigen::Matrix2Xd smooth_way(const motion::Take& take) {
  assert(take.frames() > 1 && "somebody goes somewhere");
  Eigen::Matrix2Xd way(2, take.frames());
  for (int f = 0; f < take.frames(); ++f) way.col(f) = fitted_at(take, f);
  return way;
}

StimulusFigure::StimulusFigure(std::shared_ptr<const study::Stimulus> stimulus,
                               const Mannequin& mannequin, double level_m)
    : stimulus_(std::move(stimulus)),
      mannequin_(mannequin),
      level_m_(level_m),
      camera_(smooth_way(stimulus_->take)) {}

Eigen::Vector2d StimulusFigure::camera_at(double seconds) const {
  const double frame = std::clamp(seconds / stimulus_->take.frame_time, 0.0,
                                  static_cast<double>(camera_.cols() - 1));
  const auto before = std::min(static_cast<Eigen::Index>(frame), camera_.cols() - 2);
  const double share = frame - static_cast<double>(before);
  return (1 - share) * camera_.col(before) + share * camera_.col(before + 1);
}

motion::Pose StimulusFigure::pose_at(double seconds) const {
  motion::Pose pose = motion::pose_at(stimulus_->take, seconds / stimulus_->take.frame_time);
  const Eigen::Vector2d camera = camera_at(seconds);
  pose.root -= Eigen::Vector3d(camera.x(), level_m_, camera.y());
  return pose;
}

Eigen::Vector2d StimulusFigure::way(const study::StimulusMoment& moment) const {
  const Eigen::Vector2d round = camera_.col(camera_.cols() - 1) - camera_.col(0);
  return camera_at(moment.seconds) - camera_.col(0) + moment.round * round;
}

StimulusFigures::StimulusFigures(const StimulusList& stimuli, const motion::Skeleton& skeleton,
                                 const Mannequin& mannequin) {
  // Stimuli of one graph are one figure.
  std::map<const motion::MotionGraph*, std::pair<Mannequin, double>> figures;
  for (const auto& stimulus : stimuli) {
    const motion::MotionGraph& graph = *stimulus->graph;
    if (!figures.contains(&graph)) {
      const double level = floor_level(graph);
      const bool alike = study::same_bones(graph.skeleton(), skeleton);
      figures.emplace(&graph, std::pair(alike ? mannequin : mannequin_of(graph, level), level));
    }
    const auto& [figure, level] = figures.at(&graph);
    figures_.emplace(stimulus.get(), StimulusFigure(stimulus, figure, level));
  }
}

const StimulusFigure& StimulusFigures::of(const study::Stimulus& stimulus) const {
  const auto found = figures_.find(&stimulus);
  assert(found != figures_.end() && "the stage was told of it");
  return found->second;
}

}  // namespace promenade::app
