// The ways in which programs write one and the same BVH: each must put the joints where
// the plain way puts them.
#include <gtest/gtest.h>

#include "motion/bvh.h"
#include "tests/motion/toy_bvh.h"

namespace promenade::motion {
namespace {

struct Dialect {
  const char* name;
  std::string text;
  std::size_t warnings = 0;
  std::string leg = "Leg";  // what its second joint is called
};

class BvhDialects : public testing::TestWithParam<Dialect> {};

TEST_P(BvhDialects, PutTheJointsInTheSamePlaces) {
  const Clip plain = read_bvh(toy_bvh, "plain.bvh");
  const Clip clip = read_bvh(GetParam().text, "dialect.bvh");
  EXPECT_EQ(clip.warnings.size(), GetParam().warnings);
  ASSERT_EQ(clip.frames(), 2);
  const int leg = find_joint(clip.skeleton, GetParam().leg);
  ASSERT_GE(leg, 1);
  const int hips = clip.skeleton.joints[static_cast<std::size_t>(leg)].parent;
  for (int f = 0; f < 2; ++f) {
    const WorldPose expected = forward_kinematics(plain, f), found = forward_kinematics(clip, f);
    EXPECT_TRUE(found.positions.col(hips).isApprox(expected.positions.col(0), 1e-14)) << f;
    EXPECT_TRUE(found.positions.col(leg).isApprox(expected.positions.col(1), 1e-14)) << f;
    EXPECT_TRUE(found.rotations[static_cast<std::size_t>(leg)].toRotationMatrix().isApprox(
        expected.rotations[1].toRotationMatrix(), 1e-14))
        << f;
  }
}

// The toy with other channels of the hips and other values.
std::string with_channels(const std::string& hips, const std::string& first,
                          const std::string& second) {
  std::string text = replaced(toy_bvh, "4 Xposition Zrotation Xrotation Yrotation", hips);
  return replaced(replaced(text, "5 90 0 0 0 -40", first), "6 0 0 90 90 -50", second);
}

std::string with_values(const std::string& values) {
  return replaced(toy_bvh, "5 90 0 0 0 -40\n6 0 0 90 90 -50\n", values);
}

std::string with_line_ends(const std::string& end) {
  std::string text;
  for (const char c : toy_bvh) text += c == '\n' ? end : std::string(1, c);
  return text;
}

std::string in_lower_case() {
  std::string text = toy_bvh;
  for (const char* word : {"HIERARCHY", "ROOT", "OFFSET", "CHANNELS", "JOINT", "End Site", "MOTION",
                           "Frames", "Frame Time", "Xposition", "Zrotation"}) {
    std::string lower = word;
    for (char& c : lower) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c;
    for (std::size_t at = 0; (at = text.find(word, at)) != text.npos;) {
      text.replace(at, lower.size(), lower);
    }
  }
  return text;
}

const std::string prop =
    "ROOT Ball\n{\nOFFSET 0 0 0\nCHANNELS 3 Xposition Yposition Zposition\n"
    "JOINT a\n{\nOFFSET 1 0 0\n}\nJOINT b\n{\nOFFSET 1 0 0\n}\n}\n";

std::vector<Dialect> channel_dialects() {
  return {
      {"Plain", toy_bvh},
      {"RotationBeforePosition", with_channels("4 Zrotation Xrotation Yrotation Xposition",
                                               "90 0 0 5 0 -40", "0 0 90 6 90 -50")},
      {"PositionBetweenRotations", with_channels("4 Zrotation Xrotation Xposition Yrotation",
                                                 "90 0 5 0 0 -40", "0 0 6 90 90 -50")},
      {"SixChannels", with_channels("6 Yposition Zposition Xposition Zrotation Xrotation Yrotation",
                                    "90 0 5 90 0 0 0 -40", "90 0 6 0 0 90 90 -50")},
      {"PositionsOnEveryJoint",
       replaced(with_values("5 90 0 0 0 0 -40 0\n6 0 0 90 90 0 -50 0\n"), "2 Xrotation Yposition",
                "4 Xrotation Xposition Yposition Zposition")},
      {"OneRotation",
       with_channels("3 Xposition Zrotation Yrotation", "5 90 0 0 -40", "6 0 90 90 -50")},
      {"OffsetThatIsReplaced", replaced(toy_bvh, "OFFSET 0 90 0", "OFFSET 777 90 0")},
      {"ZeroChannels", replaced(toy_bvh, "End Site\n",
                                "JOINT Foot\n{\nOFFSET 0 -1 0\nCHANNELS "
                                "0\n}\nEnd Site\n")},
      {"NoChannels",
       replaced(toy_bvh, "End Site\n", "JOINT Foot\n{\nOFFSET 0 -1 0\n}\nEnd Site\n")},
      {"NoEndSite", replaced(toy_bvh, "    End Site\n    {\n      OFFSET 0 -40 0\n    }\n", "")},
      {"EndSiteInOneWord", replaced(toy_bvh, "End Site", "EndSite")},
      {"EndSiteWithAName", replaced(toy_bvh, "End Site", "End Site Leg tip")},
      {"TwoEndSites", replaced(toy_bvh, "End Site\n", "End Site\n{\nOFFSET 1 2 3\n}\nEnd Site\n")},
      {"HipsBelowARoot",
       replaced(replaced(with_values("0 0 0 5 90 0 0 0 -40\n0 0 0 6 0 0 90 90 -50\n"), "ROOT Hips",
                         "ROOT World\n{\nOFFSET 0 0 0\nCHANNELS 3 Zrotation "
                         "Xposition Zposition\nJOINT Hips"),
                "}\nMOTION", "}\n}\nMOTION")},
      {"PropBeforeTheFigure",
       replaced(with_values("7 8 9 5 90 0 0 0 -40\n7 8 9 6 0 0 90 90 -50\n"), "HIERARCHY\n",
                "HIERARCHY\n" + prop),
       1},
      {"PropBehindTheFigure",
       replaced(with_values("5 90 0 0 0 -40 7 8 9\n6 0 0 90 90 -50 7 8 9\n"), "MOTION",
                prop + "MOTION"),
       1}};
}

std::vector<Dialect> layout_dialects() {
  return {{"CrLf", with_line_ends("\r\n")},
          {"Cr", with_line_ends("\r")},
          {"MixedLineEnds", replaced(with_line_ends("\r\n"), "MOTION\r\n", "MOTION\n")},
          {"ByteOrderMark", "\xef\xbb\xbf" + toy_bvh},
          {"Tabs", replaced(with_values("5\t90\t0\t0\t0\t-40\t\n6\t0\t0\t90\t90\t-50\t\n"),
                            "Frames: 2", "Frames:\t2")},
          {"BlankLines", replaced(with_values("\n5 90 0 0 0 -40 \n \n\t\n6 0 0 90 90 -50\n\n"),
                                  "MOTION\n", "\nMOTION\n\n")},
          {"NoLineEndAtTheEnd", toy_bvh.substr(0, toy_bvh.size() - 1)},
          {"EndOfFileOfDos", toy_bvh + "\x1a"},
          {"OneValueALine", with_values("5\n90\n0\n0\n0\n-40\n6\n0\n0\n90\n90\n-50\n")},
          {"SomeValuesALine", with_values("5 90 0 0\n0 -40\n6 0 0 90\n90 -50\n")},
          {"AllOnOneLine", with_values("5 90 0 0 0 -40 6 0 0 90 90 -50")},
          {"OneFrameMore", toy_bvh + "7 1 1 1 1 1\n", 1},
          {"APartOfAFrameMore", toy_bvh + "7 1 1\n", 1},
          {"LowerCase", in_lower_case()},
          {"BracesOnTheLine",
           replaced(replaced(toy_bvh, "Hips\n{", "Hips{"), "  }\n}\nMOTION", "}}MOTION")},
          {"LabelsApart", replaced(replaced(toy_bvh, "Frames: ", "Frames : "), "Time:", "Time :")},
          {"LabelsGlued", replaced(replaced(toy_bvh, "Frames: ", "Frames:"), "Time: ", "Time:")}};
}

std::vector<Dialect> number_and_name_dialects() {
  return {
      {"TwoDigitExponents", with_values("5e+00 9.0E+01 0e-10 -0 0 -4e1\n6 0 0 90 90 -.5e+02\n")},
      {"ThreeDigitExponents",
       with_values("5e+000 9e001 0e-010 0 0 -4e+001\n6 0 0 90 90 -5e+001\n")},
      {"PlusSigns", with_values("+5 +90 0 0 0 -40\n6 0 0 +90. 90 -50\n")},
      {"ManyDigits", with_values("5.00000000000000000000 90 0 0 0 -40\n6 0 0 90 90 -50\n")},
      {"WrappedAngles", with_values("5 -270 360 -360 0 -40\n6 720 0 450 -630 -50\n")},
      {"CountedTurns", with_values("5 3690 0 0 0 -40\n6 0 0 -36000000270 90 -50\n")},
      {"NameWithSpaces", replaced(toy_bvh, "JOINT Leg", "JOINT left leg 1"), 0, "left leg 1"},
      {"NameWithPrefix", replaced(toy_bvh, "JOINT Leg", "JOINT mixamorig:Leg"), 0, "mixamorig:Leg"},
      {"NameOfMotive", replaced(toy_bvh, "JOINT Leg", "JOINT Skeleton 001:Leg"), 0,
       "Skeleton 001:Leg"},
      {"NameInUtf8", replaced(toy_bvh, "JOINT Leg", "JOINT \xe8\x84\x9a"), 0, "\xe8\x84\x9a"},
      {"NameInLatin1", replaced(toy_bvh, "JOINT Leg", "JOINT Fu\xdf"), 0, "Fu\xdf"},
      {"NameOfAKeyword", replaced(toy_bvh, "JOINT Leg", "JOINT End"), 0, "End"},
      {"SameNames", replaced(toy_bvh, "JOINT Leg", "JOINT Hips"), 1, "Hips_2"}};
}

const auto name_of = [](const auto& instance) { return std::string(instance.param.name); };
INSTANTIATE_TEST_SUITE_P(Channels, BvhDialects, testing::ValuesIn(channel_dialects()), name_of);
INSTANTIATE_TEST_SUITE_P(Layout, BvhDialects, testing::ValuesIn(layout_dialects()), name_of);
INSTANTIATE_TEST_SUITE_P(Words, BvhDialects, testing::ValuesIn(number_and_name_dialects()),
                         name_of);

TEST(Bvh, MayRunAtAnyRate) {
  for (const int rate : {24, 25, 30, 60, 100, 119, 120, 240}) {
    const std::string text = replaced(toy_bvh, "0.05", std::to_string(1.0 / rate));
    EXPECT_NEAR(read_bvh(text, "x").frame_time, 1.0 / rate, 1e-6);
  }
}

TEST(Bvh, WithACommaForAPointIsToldSo) {
  try {
    read_bvh(replaced(toy_bvh, "0.05", "0,05"), "x");
    FAIL();
  } catch (const InputError& error) {
    EXPECT_NE(error.problems()[0].message.find("want a point"), std::string::npos);
  }
}

TEST(Bvh, DoesNotSteerTheTerminalWithItsWords) {
  try {
    read_bvh(replaced(toy_bvh, "90 90", "90 \x1b[2J"), "x");
    FAIL();
  } catch (const InputError& error) {
    EXPECT_NE(error.problems()[0].message.find("'?[2J'"), std::string::npos);
  }
}

}  // namespace
}  // namespace promenade::motion
