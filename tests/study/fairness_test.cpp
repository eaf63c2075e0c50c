#include "study/fairness.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "study/reach_models.h"
#include "toy.h"

namespace promenade::study {
namespace {

TEST(MedianStyleDistance, IsTheMiddleOfAllPairs) {
  const motion::MotionSpace space = toy::bundle().space;
  std::vector<double> pairs;
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < i; ++j) {
      pairs.push_back(motion::distance(space.set, space.set.cycles[static_cast<std::size_t>(i)],
                                       space.set.cycles[static_cast<std::size_t>(j)])
                          .mean_m);
    }
  }
  std::sort(pairs.begin(), pairs.end());
  EXPECT_NEAR(median_style_distance(space), pairs[1], 1e-12);
}

TEST(AutomaticThreshold, LeavesEveryTargetUnwonAtTheStart) {
  const StudyBundle bundle = toy::bundle();
  Task task = bundle.study.tasks[0];
  task.targets[0].weights = Eigen::Vector3d(0.3, 0.3, 0.4);  // close to the average
  const double start = start_distance(bundle.space, *task.targets[0].weights);
  EXPECT_DOUBLE_EQ(automatic_threshold(bundle.space, task), 0.8 * start);
}

TEST(AutomaticThreshold, IsHalfTheMedianWhereTargetsAreFar) {
  const StudyBundle bundle = toy::bundle();
  Task task = bundle.study.tasks[0];
  task.practice.clear();
  task.targets[0].weights = Eigen::Vector3d(-1, -1, 3);
  EXPECT_DOUBLE_EQ(automatic_threshold(bundle.space, task),
                   0.5 * median_style_distance(bundle.space));
}

TEST(Reach, FindsExamplesWithADiscreteInterface) {
  const StudyBundle bundle = toy::bundle();
  const Task& task = bundle.study.tasks[0];
  const Reach found = reach(bundle, toy::registry(), task, 0, task.targets[0],
                            {.threshold_m = judged_threshold(bundle.space, task)});
  EXPECT_NEAR(found.best, 0, 1e-9);
  EXPECT_NEAR(found.best_example, 0, 1e-9);
  EXPECT_NEAR(found.share_below, 1.0 / 3, 0.15);  // one of three labels; 4 sigma of 200
}

TEST(Reach, SeesThatAMixtureIsOutOfReachOfLabels) {
  const StudyBundle bundle = toy::bundle();
  Target target;
  target.weights = Eigen::Vector3d(0, 0.5, 0.5);
  const Task& task = bundle.study.tasks[0];
  const Reach labels = reach(bundle, toy::registry(), task, 0, target, {});
  const Reach sliders = reach(bundle, toy::registry(), task, 1, target, {});
  EXPECT_NEAR(labels.best, labels.best_example, 1e-9);
  EXPECT_GT(labels.best, 0.05);
  EXPECT_LT(sliders.best, 0.01);
}

TEST(Reach, CountsTheShareBelowTheThresholdItIsGiven) {
  StudyBundle bundle = toy::bundle();
  Task& task = bundle.study.tasks[0];
  task.threshold_m.reset();  // of the study: only Done ends it
  const Target& target = task.targets[0];
  EXPECT_EQ(reach(bundle, toy::registry(), task, 1, target, {.threshold_m = 100}).share_below, 1);
  EXPECT_EQ(reach(bundle, toy::registry(), task, 1, target, {.threshold_m = 0}).share_below, 0);
}

TEST(Reach, IsTheSameEveryTime) {
  const StudyBundle bundle = toy::bundle();
  const Task& task = bundle.study.tasks[0];
  const Reach one = reach(bundle, toy::registry(), task, 1, task.targets[0],
                          {.threshold_m = judged_threshold(bundle.space, task)});
  const Reach two = reach(bundle, toy::registry(), task, 1, task.targets[0],
                          {.threshold_m = judged_threshold(bundle.space, task)});
  EXPECT_EQ(one.best, two.best);
  EXPECT_EQ(one.share_below, two.share_below);
}

}  // namespace
}  // namespace promenade::study
