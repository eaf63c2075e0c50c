#include "motion/shared_skeleton.h"

#include <gtest/gtest.h>

#include "tests/motion/walker.h"

namespace promenade::motion {
namespace {

Take walker() {
  const MotionSet set = builtin_set("A").value();
  return walker_take(set, set.cycles[0], 1);
}

Take scaled(Take take, double scale) {
  for (Joint& joint : take.skeleton.joints) joint.offset *= scale;
  return take;
}

TEST(SharedSkeleton, HasTheMeanOfTheBonesOrThoseOfOneTake) {
  const Take one = walker();
  const std::vector<Take> takes = {one, scaled(one, 0.8)};
  const double leg = leg_length(one.skeleton, one.body);
  const SharedSkeleton mean = shared_skeleton(takes);
  EXPECT_NEAR(leg_length(mean.skeleton, mean.body), 0.9 * leg, 1e-12);
  const SharedSkeleton small = shared_skeleton(takes, 1);
  EXPECT_NEAR(leg_length(small.skeleton, small.body), 0.8 * leg, 1e-12);
}

TEST(SharedSkeleton, IsThatOfMostTakes) {
  Take other = walker();
  other.skeleton.joints.back().name = "Tail";
  const SharedSkeleton shared = shared_skeleton({other, walker(), walker()});
  EXPECT_EQ(find_joint(shared.skeleton, "Tail"), -1);
}

TEST(FitTo, FindsJointsInAnotherOrderAndWithAPrefix) {
  const Take take = walker();
  const SharedSkeleton shared{take.skeleton, take.body};
  Take moved = take;
  const std::size_t last = take.skeleton.joints.size() - 1;
  ASSERT_NE(take.skeleton.joints[last].parent, static_cast<int>(last) - 1 + 1);
  for (Joint& joint : moved.skeleton.joints) joint.name = "Anna:" + joint.name;
  const Fitted fitted = fit_to(shared, moved);
  EXPECT_EQ(fitted.refusal, "");
  EXPECT_TRUE(fitted.lent.empty());
  EXPECT_EQ(fitted.take.skeleton.joints[last].name, take.skeleton.joints[last].name);
  EXPECT_EQ(fitted.take.poses[3].rotations[last].coeffs(), take.poses[3].rotations[last].coeffs());
}

TEST(FitTo, LeavesOutWhatTheSetLacksAndLendsWhatIsBeyondTheBody) {
  const Take take = walker();
  SharedSkeleton shared{take.skeleton, take.body};
  const int joints = shared.skeleton.size();
  shared.skeleton.joints.push_back({"LeftFinger", take.body.joint[left_wrist], {0.1, 0, 0}});
  const Fitted fitted = fit_to(shared, take);
  EXPECT_EQ(fitted.refusal, "");
  EXPECT_EQ(fitted.lent, std::vector<std::string>{"LeftFinger"});
  EXPECT_TRUE(fitted.take.poses[0].rotations.back().isApprox(Eigen::Quaterniond::Identity()));
  Take longer = fitted.take;
  EXPECT_EQ(fit_to({take.skeleton, take.body}, longer).take.skeleton.size(), joints);
}

TEST(FitTo, RefusesByNameWhatTheBodyLacks) {
  const Take take = walker();
  const SharedSkeleton shared{take.skeleton, take.body};
  Take other = take;
  Joint& knee = other.skeleton.joints[static_cast<std::size_t>(take.body.joint[left_knee])];
  const std::string name = knee.name;
  knee.name = "Wheel";
  const std::string said = fit_to(shared, other).refusal;
  EXPECT_NE(said.find("lacks " + name), std::string::npos) << said;
}

TEST(FitTo, RefusesAnotherRestPose) {
  const Take take = walker();
  const SharedSkeleton shared{take.skeleton, take.body};
  Take other = take;
  const auto ankle = static_cast<std::size_t>(take.body.joint[left_ankle]);
  const Eigen::Vector3d bone = other.skeleton.joints[ankle].offset;
  other.skeleton.joints[ankle].offset = Eigen::Vector3d(bone.norm(), 0, 0);
  const std::string said = fit_to(shared, other).refusal;
  EXPECT_NE(said.find("at rest"), std::string::npos) << said;
  EXPECT_NE(said.find(take.skeleton.joints[ankle].name), std::string::npos) << said;
}

}  // namespace
}  // namespace promenade::motion
