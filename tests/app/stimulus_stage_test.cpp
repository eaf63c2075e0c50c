// Where a stimulus is on the stage at any of its moments.
#include "app/stimulus_stage.h"

#include <gtest/gtest.h>

#include <cmath>

#include "app/stage.h"
#include "tests/app/panel_bench.h"
#include "tests/app/walks_graph.h"

namespace promenade::app {
namespace {

using study::Stimulus;

// The happy walk as it was taken, straight on: from its first way out to its last.
std::shared_ptr<const Stimulus> straight() {
  const auto graph = std::make_shared<const motion::MotionGraph>(bench::walks_graph());
  std::vector<int> edges;
  for (std::size_t e = 0; e < graph->edges.size(); ++e) {
    const motion::GraphEdge& edge = graph->edges[e];
    const bool goes_on = edges.empty() || graph->edge(edges.back()).to == edge.from;
    if (edge.transition < 0 && goes_on) edges.push_back(static_cast<int>(e));
  }
  return std::make_shared<const Stimulus>(study::make_stimulus("happy", graph, edges));
}

// The same, along a curve: 90 degrees in its time.
std::shared_ptr<const Stimulus> turning() {
  auto turned = std::make_shared<Stimulus>(*straight());
  const double radius = turned->take.poses.back().root.z() / (0.5 * M_PI);
  for (motion::Pose& pose : turned->take.poses) {
    const double angle = pose.root.z() / radius;
    const Eigen::Quaterniond turn(Eigen::AngleAxisd(angle, Eigen::Vector3d::UnitY()));
    const double out = radius - pose.root.x();
    pose.root = {radius - out * std::cos(angle), pose.root.y(), out * std::sin(angle)};
    pose.rotations.front() = turn * pose.rotations.front();
  }
  return turned;
}

StimulusFigure figure_of(std::shared_ptr<const Stimulus> stimulus) {
  return StimulusFigure(std::move(stimulus), make_mannequin(bench::space().set), 0);
}

TEST(StimulusFigure, IsWhereItsTakeIs) {
  const auto stimulus = turning();
  const StimulusFigure figure = figure_of(stimulus);
  const Eigen::Vector3d first = figure.pose_at(0).root - stimulus->take.poses[0].root;
  for (const double seconds : {0.4, 1.0, 2.3}) {
    const motion::Pose wanted = motion::pose_at(stimulus->take, seconds * bench::graph_rate);
    const motion::Pose pose = figure.pose_at(seconds);
    const Eigen::Vector2d way = figure.way({0, seconds});
    const Eigen::Vector3d place = pose.root + Eigen::Vector3d(way.x(), 0, way.y()) - first;
    EXPECT_LT((place - wanted.root).norm(), 1e-12);
    for (std::size_t j = 0; j < pose.rotations.size(); ++j) {
      EXPECT_EQ(pose.rotations[j].coeffs(), wanted.rotations[j].coeffs());
    }
  }
}

// A pelvis sways by some centimetres; a camera that lagged would leave it behind.
TEST(StimulusFigure, KeepsItsSpotAlsoWhereItTurns) {
  const auto stimulus = turning();
  const StimulusFigure figure = figure_of(stimulus);
  for (double seconds = 0; seconds < stimulus->seconds(); seconds += 0.1) {
    const Eigen::Vector3d root = figure.pose_at(seconds).root;
    EXPECT_LT(std::hypot(root.x(), root.z()), 0.08) << seconds;
  }
}

TEST(StimulusFigure, GoesOnFromWhereItWasWhenItBeginsAgain) {
  const auto stimulus = turning();
  const StimulusFigure figure = figure_of(stimulus);
  EXPECT_EQ(figure.way({0, stimulus->seconds()}), figure.way({1, 0}));
  EXPECT_GT(figure.way({1, 0}).norm(), 1);
}

TEST(SmoothWay, OfAStraightWayIsItself) {
  motion::Take take;
  take.frame_time = 0.02;
  for (int f = 0; f < 100; ++f) take.poses.push_back({{0.3 - 0.01 * f, 1, 0.02 * f}, {}});
  const Eigen::Matrix2Xd way = smooth_way(take);
  for (int f = 0; f < 100; ++f) {
    EXPECT_NEAR(way(0, f), 0.3 - 0.01 * f, 1e-12);
    EXPECT_NEAR(way(1, f), 0.02 * f, 1e-12);
  }
}

// A sway of a hertz comes down to exp(-(2 pi 0.4)^2 / 2) = 4 %.
TEST(SmoothWay, LeavesOutTheSwayOfSteps) {
  motion::Take take;
  take.frame_time = 0.02;
  for (int f = 0; f < 300; ++f) {
    take.poses.push_back({{0.03 * std::sin(2 * M_PI * 0.02 * f), 1, 0.024 * f}, {}});
  }
  const Eigen::Matrix2Xd way = smooth_way(take);
  for (int f = 100; f < 200; ++f) EXPECT_LT(std::abs(way(0, f)), 0.03 * 0.05);
}

class StimulusOnStage : public testing::Test {
 protected:
  std::shared_ptr<const Stimulus> stimulus_ = straight();
  motion::PoseBank bank_ = motion::make_pose_bank(bench::space());
  Stage stage_{bench::space().set, bank_, true, {stimulus_}};

  // The middle of the highest part, the head.
  Eigen::Vector3f head() const {
    Eigen::Vector3f highest = Eigen::Vector3f::Zero();
    for (const Part& part : stage_.parts(Role::target)) {
      if (part.a.y() > highest.y()) highest = part.a;
    }
    return highest;
  }
  void pose(double seconds) { stage_.pose({.stimulus = stimulus_.get(), .stimulus_s = seconds}); }
};

TEST_F(StimulusOnStage, StandsInThePlaceOfTheTarget) {
  pose(0);
  EXPECT_TRUE(stage_.shows(Role::target));
  EXPECT_FALSE(stage_.shows(Role::created));
}

TEST_F(StimulusOnStage, ShowsThePoseOfItsTakeAtThatMoment) {
  const StimulusFigure figure = figure_of(stimulus_);
  for (const double seconds : {0.0, 0.7, 1.9}) {
    pose(seconds);
    std::vector<Part> wanted;
    place_parts(figure.mannequin(),
                motion::forward_kinematics(stimulus_->take.skeleton, figure.pose_at(seconds)),
                wanted);
    turn(wanted, start_yaw);
    const std::vector<Part>& shown = stage_.parts(Role::target);
    ASSERT_EQ(shown.size(), wanted.size());
    for (std::size_t i = 0; i < wanted.size(); ++i) EXPECT_EQ(shown[i].a, wanted[i].a);
    EXPECT_DOUBLE_EQ(stage_.phase(), seconds / stimulus_->seconds());
  }
}

TEST_F(StimulusOnStage, StandsAtItsEndAndBeginsAgain) {
  pose(stimulus_->seconds());
  const Eigen::Vector3f end = head();
  pose(stimulus_->seconds() + 0.4);
  EXPECT_EQ(head(), end);
  pose(0);
  const Eigen::Vector3f start = head();
  pose(stimulus_->seconds() + study::stimulus_rest_s);
  EXPECT_EQ(head(), start);
}

TEST_F(StimulusOnStage, LeavesTheReferenceInItsOwnTime) {
  const motion::Cycle& reference = bench::space().set.cycles[0];
  stage_.walk(0.3, {.reference = &reference, .stimulus = stimulus_.get(), .stimulus_s = 0.3});
  stage_.pose({.reference = &reference, .stimulus = stimulus_.get(), .stimulus_s = 0.3});
  EXPECT_TRUE(stage_.shows(Role::reference));
  EXPECT_NEAR(stage_.phase(), 0.3 / stimulus_->seconds(), 1e-12);
}

// Bones of its own: 10 % longer.
TEST(StimulusFigures, OfOtherBonesHaveAFigureOfTheirOwn) {
  motion::MotionGraph graph = bench::walks_graph();
  for (motion::GraphTake& take : graph.takes) {
    for (motion::Joint& joint : take.take.skeleton.joints) joint.offset *= 1.1;
    for (motion::Pose& pose : take.take.poses) pose.root *= 1.1;
  }
  const auto stimulus = std::make_shared<const Stimulus>(study::make_stimulus(
      "tall", std::make_shared<const motion::MotionGraph>(std::move(graph)), {0}));
  const Mannequin small = make_mannequin(bench::space().set);
  const StimulusFigures figures({stimulus}, bench::space().set.skeleton, small);
  const Mannequin& own = figures.of(*stimulus).mannequin();
  EXPECT_NEAR(own.scale, 1.1 * small.scale, 1e-9);
  EXPECT_NEAR(own.height, 1.1 * small.height, 0.05);
  // Heads and feet point ahead as those of the set do.
  EXPECT_GT(own.foot_ahead[0].dot(small.foot_ahead[0]), 0.97);
  EXPECT_GT(own.head_ahead.dot(small.head_ahead), 0.9);
}

}  // namespace
}  // namespace promenade::app
