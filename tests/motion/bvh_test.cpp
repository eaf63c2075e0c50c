#include "motion/bvh.h"

#include <gtest/gtest.h>

#include "motion/files.h"
#include "motion/load_clip.h"
#include "tests/motion/toy_bvh.h"
#include "tests/test_folder.h"

namespace promenade::motion {
namespace {

Clip toy() { return read_bvh(toy_bvh, "toy.bvh"); }

TEST(Bvh, HoldsJointsChannelsAndTime) {
  const Clip clip = toy();
  ASSERT_EQ(clip.skeleton.size(), 2);
  EXPECT_EQ(clip.skeleton.joints[1].name, "Leg");
  EXPECT_EQ(clip.skeleton.joints[1].parent, 0);
  EXPECT_EQ(clip.skeleton.end_sites.at(0).offset.y(), -40);
  EXPECT_EQ(clip.channels[0].channels.size(), 4u);
  EXPECT_EQ(clip.frames(), 2);
  EXPECT_EQ(clip.frame_time, 0.05);
  EXPECT_TRUE(clip.warnings.empty());
}

TEST(Bvh, PositionChannelsReplaceThatComponentOfTheOffsetOnAnyJoint) {
  const LocalPose pose = local_pose(toy(), 1);
  EXPECT_EQ(pose.translations.col(0), Eigen::Vector3d(6, 90, 0));
  EXPECT_EQ(pose.translations.col(1), Eigen::Vector3d(0, -50, 0));
}

// Frame 0: hips turned 90 degrees about Z bring a bone along -Y to +X. Frame 1: 90
// degrees about Y leaves it hanging.
TEST(Bvh, ForwardKinematicsAgreesWithRotationsByHand) {
  const Clip clip = toy();
  EXPECT_TRUE(forward_kinematics(clip, 0).positions.col(1).isApprox(Eigen::Vector3d(45, 90, 0)));
  EXPECT_TRUE(forward_kinematics(clip, 1).positions.col(1).isApprox(Eigen::Vector3d(6, 40, 0)));
}

TEST(Bvh, RotationsMultiplyInTheOrderOfTheirChannels) {
  const std::string text = replaced(toy_bvh, "5 90 0 0 0 -40", "5 30 40 50 0 -40");
  const auto about = [](double degrees, const Eigen::Vector3d& axis) {
    return Eigen::AngleAxisd(degrees * M_PI / 180, axis).toRotationMatrix();
  };
  const Eigen::Matrix3d expected = about(30, Eigen::Vector3d::UnitZ()) *
                                   about(40, Eigen::Vector3d::UnitX()) *
                                   about(50, Eigen::Vector3d::UnitY());
  const LocalPose pose = local_pose(read_bvh(text, "x"), 0);
  EXPECT_TRUE(pose.rotations[0].toRotationMatrix().isApprox(expected, 1e-14));
}

TEST(Bvh, ComesBackFromItsTextToTheLastBit) {
  const Clip clip = read_bvh(replaced(toy_bvh, "5 90", "0.1 1e-17"), "x");
  const Clip back = read_bvh(bvh_text(clip), "y");
  EXPECT_EQ(back.values, clip.values);
  EXPECT_EQ(back.frame_time, clip.frame_time);
  EXPECT_EQ(back.channels[1].channels, clip.channels[1].channels);
  EXPECT_EQ(back.skeleton.joints[1].offset, clip.skeleton.joints[1].offset);
  EXPECT_EQ(back.skeleton.end_sites.size(), 1u);
}

TEST(Bvh, ValuesMayBeLaidOutInAnyWay) {
  const std::string text =
      replaced(toy_bvh, "5 90 0 0 0 -40\n6 0 0 90 90 -50\n", "5\n90 0\n0\n0 -40 6\n0 0\n90 90 -50");
  EXPECT_EQ(read_bvh(text, "x").values, toy().values);
}

TEST(Bvh, TakesLineEndsKeywordsAndNumbersOfManyWriters) {
  std::string text = "\xef\xbb\xbf" + replaced(toy_bvh, "HIERARCHY", "hierarchy");
  text = replaced(text, "ROOT Hips\n{", "Root\tSkeleton 001:Hips {");
  text = replaced(text, "Frames: 2", "FRAMES :\t2");
  text = replaced(text, "5 90 0 0", "+5.0e+000 9e1 -0 1e-400");
  for (const std::string end : {"\r\n", "\r"}) {
    std::string other;
    for (const char c : text) other += c == '\n' ? end : std::string(1, c);
    const Clip clip = read_bvh(other, "x");
    EXPECT_EQ(clip.values, toy().values);
    EXPECT_EQ(clip.skeleton.joints[0].name, "Skeleton 001:Hips");
  }
}

TEST(Bvh, MoreFramesThanDeclaredAreAWarning) {
  const Clip clip = read_bvh(toy_bvh + "7 0 0 0 0 0\n", "x");
  EXPECT_EQ(clip.frames(), 2);
  ASSERT_EQ(clip.warnings.size(), 1u);
  EXPECT_NE(clip.warnings[0].message.find("declares 2 frames but has 3"), std::string::npos);
}

TEST(Bvh, JointsOfOneNameAreToldApart) {
  const Clip clip = read_bvh(replaced(toy_bvh, "JOINT Leg", "JOINT Hips"), "x");
  EXPECT_EQ(clip.skeleton.joints[1].name, "Hips_2");
  ASSERT_EQ(clip.warnings.size(), 1u);
  EXPECT_EQ(clip.warnings[0].line, 6);
}

TEST(Bvh, OfSeveralRootsTheOneWithTheHipsIsTheFigure) {
  const std::string prop =
      "ROOT Ball\n{\nOFFSET 0 0 0\nCHANNELS 1 Xposition\nJOINT a\n{\nOFFSET 0 0 0\n}\nJOINT b\n{\n"
      "OFFSET 0 0 0\n}\n}\n";
  std::string text = replaced(toy_bvh, "HIERARCHY\n", "HIERARCHY\n" + prop);
  text = replaced(text, "5 90 0", "77 5 90 0");
  text = replaced(text, "6 0 0", "77 6 0 0");
  const Clip clip = read_bvh(text, "x");
  EXPECT_EQ(clip.skeleton.joints[0].name, "Hips");
  EXPECT_EQ(local_pose(clip, 1).translations.col(0), Eigen::Vector3d(6, 90, 0));
  ASSERT_EQ(clip.warnings.size(), 1u);
  EXPECT_NE(clip.warnings[0].message.find("'Ball'"), std::string::npos);
}

TEST(Bvh, OfAHundredThousandJointsInAChainIsReadAndWritten) {
  std::string text = "HIERARCHY\nROOT r\n{\nOFFSET 0 0 0\nCHANNELS 1 Xrotation\n", closing;
  for (int j = 0; j < 100'000; ++j) {
    text += "JOINT j" + std::to_string(j) + "\n{\nOFFSET 0 0 0\n";
    closing += "}\n";
  }
  text += closing + "}\nMOTION\nFrames: 1\nFrame Time: 1\n5\n";
  const Clip clip = read_bvh(text, "x");
  EXPECT_EQ(read_bvh(bvh_text(clip), "y").skeleton.size(), 100'001);
}

struct Broken {
  const char* name;
  std::string text;
  int line, column;
  const char* says;
};

class BrokenBvh : public testing::TestWithParam<Broken> {};

TEST_P(BrokenBvh, IsRefusedWithPlaceAndReason) {
  try {
    read_bvh(GetParam().text, "bad.bvh");
    FAIL() << "it was read";
  } catch (const InputError& error) {
    const Problem& first = error.problems().front();
    EXPECT_EQ(first.file, "bad.bvh");
    EXPECT_EQ(first.line, GetParam().line) << first.message;
    EXPECT_EQ(first.column, GetParam().column) << first.message;
    EXPECT_NE(first.message.find(GetParam().says), std::string::npos) << first.message;
  }
}

std::vector<Broken> broken_files() {
  const std::string& t = toy_bvh;
  return {
      {"Empty", "", 1, 1, "empty"},
      {"Blank", " \n\n", 1, 1, "empty"},
      {"OtherFile", "PNG\n", 1, 1, "not a BVH"},
      {"CutInHierarchy", t.substr(0, t.find("End Site")), 10, 5, "the end of the file"},
      {"CutInFrame", t.substr(0, t.size() - 10), 20, 5, "holds 3 values"},
      {"CutBetweenFrames", t.substr(0, t.find("6 0 0 90")), 19, 12, "ends after 1"},
      {"MoreChannelsThanSaid", replaced(t, "CHANNELS 4", "CHANNELS 3"), 5, 44, "are more"},
      {"FewerChannelsThanSaid", replaced(t, "CHANNELS 4", "CHANNELS 5"), 6, 3, "says 5"},
      {"ChannelTwice", replaced(t, "Zrotation", "Xrotation"), 5, 34, "twice"},
      {"NoChannels", "HIERARCHY\nROOT a\n{\nOFFSET 0 0 0\n}\nMOTION\nFrames: 9\nFrame Time: 1\n", 6,
       1, "nothing can move"},
      {"TextInNumbers", replaced(t, "90 90", "90 x90"), 20, 10, "not a number"},
      {"CommaInNumbers", replaced(t, "6 0", "6,5 0"), 20, 1, "not a number"},
      {"NotANumber", replaced(t, "5 90", "nan 90"), 19, 1, "not finite"},
      {"Infinite", replaced(t, "5 90", "1e999 90"), 19, 1, "too large"},
      {"TextInOffset", replaced(t, "0 -40 0", "0 - 0"), 8, 14, "not a number"},
      {"NoOffset", replaced(t, "  OFFSET 0 90 0\n", ""), 14, 1, "without an OFFSET"},
      {"ZeroFrameTime", replaced(t, "0.05", "0"), 18, 13, "above 0"},
      {"NegativeFrameTime", replaced(t, "0.05", "-1"), 18, 13, "above 0"},
      {"ZeroFrames", replaced(t, "Frames: 2", "Frames: 0"), 17, 9, "0 frames"},
      {"HalfAFrame", replaced(t, "Frames: 2", "Frames: 1.5"), 17, 9, "whole number"},
      {"HugeCount", replaced(t, "Frames: 2", "Frames: 900000000000"), 20, 13, "ends after 2"},
      {"ShortLine", replaced(t, "6 0 0 90", "6 0 90"), 20, 11, "holds 5 values"},
      {"LongLine", replaced(t, "5 90 0", "5 90 0 0"), 19, 14, "holds 7 values"},
      {"UnclosedBlock", replaced(t, "}\nMOTION", "MOTION"), 15, 1, "closed by '}'"},
      {"NoName", replaced(t, "JOINT Leg", "JOINT"), 6, 3, "without a name"},
      {"LongName", replaced(t, "JOINT Leg", "JOINT " + std::string(1001, 'x')), 6, 3,
       "1000 letters"},
      {"MisspeltChannel", replaced(t, "Zrotation", "Zrotaton"), 5, 24, "mean 'Zrotation'?"},
      {"MisspeltKeyword", replaced(t, "CHANNELS 4", "chanels 4"), 5, 3, "mean 'CHANNELS'?"},
      {"MisspeltRoot", replaced(t, "ROOT", "ROTO"), 2, 1, "mean 'ROOT'?"},
      {"NoJoint", "HIERARCHY\n" + toy_motion, 2, 1, "no joint"}};
}

INSTANTIATE_TEST_SUITE_P(Table, BrokenBvh, testing::ValuesIn(broken_files()),
                         [](const auto& instance) { return std::string(instance.param.name); });

TEST(Bvh, NamesAllBadNumbersAtOnce) {
  try {
    read_bvh(replaced(replaced(toy_bvh, "5 90", "a 90"), "6 0", "b 0"), "x");
    FAIL();
  } catch (const InputError& error) {
    EXPECT_EQ(error.problems().size(), 2u);
  }
}

TEST(LoadClip, SaysWhereAFileIsNoText) {
  const TestFolder folder;
  const std::string file = folder.file("zero.bvh");
  write_file(file, std::string("HIERARCHY\nROOT \0 Hips", 22));
  try {
    load_clip(file);
    FAIL();
  } catch (const InputError& error) {
    EXPECT_EQ(std::string(error.what()),
              file + ":2:6: error: is not a text file: here is a byte 0");
  }
}

TEST(LoadClip, RefusesFoldersMissingFilesAndOtherKinds) {
  const TestFolder folder;
  EXPECT_THROW(load_clip(folder.path().string()), InputError);
  EXPECT_THROW(load_clip(folder.file("none.bvh")), InputError);
  const std::string other = folder.file("a.fbx");
  write_file(other, "x");
  EXPECT_THROW(load_clip(other), InputError);
}

}  // namespace
}  // namespace promenade::motion
