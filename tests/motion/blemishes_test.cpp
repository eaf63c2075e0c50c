#include "motion/blemishes.h"

#include <gtest/gtest.h>

#include "motion/body_mapping.h"
#include "tests/motion/walker.h"

namespace promenade::motion {
namespace {

Clip walker() {
  const MotionSet set = builtin_set("A").value();
  return walker_clip(set, set.cycles[0], 3);
}

// The clip with so many frames in front, all with these values but where the first stands.
Clip with_front(const Clip& clip, const Eigen::VectorXd& pose, int frames) {
  Clip longer = clip;
  longer.values.resize(clip.values.rows(), clip.frames() + frames);
  longer.values.leftCols(frames) = pose.replicate(1, frames);
  longer.values.topLeftCorner(3, frames) = clip.values.block(0, 0, 3, 1).replicate(1, frames);
  longer.values.rightCols(clip.frames()) = clip.values;
  return longer;
}

bool warns(const Clip& clip, const std::string& of) {
  for (const Problem& note : find_figure(clip).notes) {
    if (note.message.find(of) != std::string::npos) return true;
  }
  return false;
}

TEST(Blemishes, AreNotSeenInAPlainWalk) {
  const Figure figure = find_figure(walker());
  EXPECT_EQ(figure.t_pose_frames, 0);
  EXPECT_TRUE(figure.gaps.empty());
}

TEST(Blemishes, OfARestPoseInFrontAreNamedWithTheirFrames) {
  const Clip clip = walker();
  const Eigen::VectorXd rest = Eigen::VectorXd::Zero(clip.values.rows());
  EXPECT_EQ(find_figure(with_front(clip, rest, 1)).t_pose_frames, 1);
  EXPECT_TRUE(warns(with_front(clip, rest, 1), "front of the motion: frame 0"));
  EXPECT_EQ(find_figure(with_front(clip, rest, 7)).t_pose_frames, 7);
  EXPECT_TRUE(warns(with_front(clip, rest, 7), "front of the motion: frames 0 to 6"));
}

// Arms that hang in the walk are lifted about Z, with a little noise in every frame.
Clip with_lifted_arms(const Clip& clip, double degrees, int frames) {
  const Figure figure = find_figure(clip);
  Clip longer = with_front(clip, clip.values.col(0), frames);
  for (const auto& [part, sign] : {std::pair{left_shoulder, 1.0}, {right_shoulder, -1.0}}) {
    const WorldPose pose = forward_kinematics(clip, 0);
    const auto joint = static_cast<std::size_t>(figure.body.joint[part]);
    const auto elbow = figure.body.joint[part + 1U];
    const Eigen::Vector3d arm =
        pose.positions.col(elbow) - pose.positions.col(figure.body.joint[part]);
    const Eigen::Vector3d wanted(sign * std::sin(degrees * M_PI / 180),
                                 -std::cos(degrees * M_PI / 180), 0);
    const Eigen::Quaterniond parent =
        pose.rotations[static_cast<std::size_t>(clip.skeleton.joints[joint].parent)];
    const Eigen::Quaterniond lift = Eigen::Quaterniond::FromTwoVectors(arm, wanted);
    const Eigen::Quaterniond local = parent.conjugate() * lift * pose.rotations[joint];
    const JointChannels& own = clip.channels[joint];
    int row = own.first_row + static_cast<int>(own.channels.size()) - 3;
    const auto axis = [&](int c) {
      return static_cast<int>(own.channels[own.channels.size() - 3 + static_cast<std::size_t>(c)]) %
             3;
    };
    const Eigen::Vector3d angles = local.toRotationMatrix().eulerAngles(axis(0), axis(1), axis(2));
    for (int f = 0; f < frames; ++f) {
      longer.values.block<3, 1>(row, f) =
          angles * (180 / M_PI) + Eigen::Vector3d::Constant(0.01 * (f % 5));
    }
  }
  // Straight elbows.
  for (const BodyJoint part : {left_elbow, right_elbow}) {
    const JointChannels& own = clip.channels[static_cast<std::size_t>(figure.body.joint[part])];
    const int row = own.first_row + static_cast<int>(own.channels.size()) - 3;
    longer.values.block(row, 0, 3, frames).setZero();
  }
  return longer;
}

TEST(Blemishes, OfArmsHeldOutInFrontAreATPose) {
  EXPECT_EQ(find_figure(with_lifted_arms(walker(), 90, 12)).t_pose_frames, 12);
  EXPECT_EQ(find_figure(with_lifted_arms(walker(), 75, 12)).t_pose_frames, 12);
  EXPECT_EQ(find_figure(with_lifted_arms(walker(), 45, 12)).t_pose_frames, 0);
}

// It begins where the walk does, and its arms go on as they are.
TEST(Blemishes, AreNotThatAWalkBeginsWithArmsHeldOut) {
  const Clip walk = walker();
  const Clip held = with_lifted_arms(walk, 90, walk.frames());
  Clip clip = walk;
  const Figure figure = find_figure(walk);
  for (const BodyJoint part : {left_shoulder, right_shoulder, left_elbow, right_elbow}) {
    const JointChannels& own = walk.channels[static_cast<std::size_t>(figure.body.joint[part])];
    const auto count = static_cast<Eigen::Index>(own.channels.size());
    clip.values.middleRows(own.first_row, count) =
        held.values.block(own.first_row, 0, count, walk.frames());
  }
  EXPECT_EQ(find_figure(clip).t_pose_frames, 0);
}

TEST(Blemishes, OfAFrozenFigureAreNamedWithTheirFrames) {
  Clip clip = walker();
  for (int f = 21; f <= 30; ++f) clip.values.col(f) = clip.values.col(20);
  clip.values.col(51) = clip.values.col(50);  // two equal frames are no gap
  const std::vector<Gap> gaps = find_gaps(clip);
  ASSERT_EQ(gaps.size(), 1U);
  EXPECT_EQ(gaps[0].joint, -1);
  EXPECT_EQ(gaps[0].frames.first, 20);
  EXPECT_EQ(gaps[0].frames.last, 30);
  EXPECT_TRUE(warns(clip, "the figure is frozen in place in frames 20 to 30"));
}

TEST(Blemishes, OfAFrozenJointAreNamedWithTheJoint) {
  Clip clip = walker();
  const int knee = find_figure(clip).body.joint[left_hip];
  const JointChannels& own = clip.channels[static_cast<std::size_t>(knee)];
  const auto rows = static_cast<Eigen::Index>(own.channels.size());
  for (int f = 31; f <= 45; ++f) {
    clip.values.block(own.first_row, f, rows, 1) = clip.values.block(own.first_row, 30, rows, 1);
  }
  const std::vector<Gap> gaps = find_gaps(clip);
  ASSERT_EQ(gaps.size(), 1U);
  EXPECT_EQ(gaps[0].joint, knee);
  EXPECT_TRUE(warns(clip, "is frozen in place in frames 30 to 45"));
}

TEST(Blemishes, AreNotThatAHingeIsHeldStraight) {
  Clip clip = walker();
  const int knee = find_figure(clip).body.joint[left_knee];
  const JointChannels& own = clip.channels[static_cast<std::size_t>(knee)];
  const int row = own.first_row + static_cast<int>(own.channels.size()) - 3;
  clip.values.middleRows(row + 1, 2).setZero();
  clip.values.block(row, 30, 1, 15).setZero();
  EXPECT_TRUE(find_gaps(clip).empty());
}

TEST(Blemishes, AreNotThatAFigureStandsStill) {
  Clip clip = walker();
  clip.values = clip.values.col(0).replicate(1, 50).eval();
  const Figure figure = find_figure(clip);
  EXPECT_TRUE(figure.gaps.empty());
  EXPECT_EQ(figure.t_pose_frames, 0);
}

}  // namespace
}  // namespace promenade::motion
