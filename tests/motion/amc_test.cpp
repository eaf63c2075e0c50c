#include "motion/amc.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include "motion/bvh.h"
#include "motion/files.h"
#include "motion/load_clip.h"
#include "motion/plain_clip.h"
#include "tests/motion/toy_asf.h"
#include "tests/motion/toy_bvh.h"

namespace promenade::motion {
namespace {

namespace fs = std::filesystem;

Clip toy(const std::string& amc = toy_amc) {
  return read_amc(amc, "toy_1.amc", read_asf(toy_asf, "toy.asf"));
}

TEST(Amc, HoldsTheValuesOfEveryFrame) {
  const Clip clip = toy();
  EXPECT_EQ(clip.format, "asf/amc");
  ASSERT_EQ(clip.frames(), 2);
  Eigen::VectorXd second(10);
  second << 5, 6, 8, 0, 90, 0, 10, 20, 30, -45;
  EXPECT_EQ(clip.values.col(1), second);
  EXPECT_EQ(clip.unit_m, 0.0254 / 0.5);
}

TEST(Amc, MayNameBonesInAnyOrder) {
  std::string text = replaced(toy_amc, "up 0 0 0\narm 90\n", "arm 90\nup 0 0 0\n");
  EXPECT_EQ(toy(text).values, toy().values);
  text = replaced(text, "root 5 6 8 0 90 0\nup 10 20 30\n", "up 10 20 30\nROOT 5 6 8 0 90 0\n");
  EXPECT_THROW(toy(text), InputError);  // names are told apart by their case
  EXPECT_EQ(toy(replaced(text, "ROOT", "root")).values, toy().values);
}

TEST(Amc, MayCountItsFramesFromAnyNumber) {
  std::string text = replaced(toy_amc, "\n1\n", "\n100\n");
  EXPECT_EQ(toy(replaced(text, "\n2\n", "\n101\n")).values, toy().values);
}

TEST(Amc, SaysItsRateOrIsTakenAt120WithAWarning) {
  const Clip clip = toy();
  EXPECT_EQ(clip.frame_time, 1 / 120.0);
  ASSERT_EQ(clip.warnings.size(), 1U);
  EXPECT_NE(clip.warnings[0].message.find("frame rate"), std::string::npos);
  const Clip other = toy(replaced(toy_amc, ":DEGREES", ":degrees\n:samples-per-second 60"));
  EXPECT_EQ(other.frame_time, 1 / 60.0);
  EXPECT_TRUE(other.warnings.empty());
  EXPECT_EQ(read_amc(toy_amc, "x", read_asf(toy_asf, "y"), 50).frame_time, 0.02);
}

TEST(Amc, MayWriteItsAnglesInRadians) {
  const Clip clip = toy(replaced(toy_amc, ":DEGREES", ":RADIANS"));
  EXPECT_DOUBLE_EQ(clip.values(9, 0), 90 * 180 / M_PI);
  EXPECT_EQ(clip.values(0, 0), 5);
}

TEST(Amc, TakesLineEndsBlanksAndNumbersOfManyWriters) {
  std::string text = replaced(toy_amc, "up 0 0 0", "\n  up\t+0e-015  -0 .0 \n# between");
  for (const std::string end : {"\r\n", "\r"}) {
    std::string other;
    for (const char c : text) other += c == '\n' ? end : std::string(1, c);
    EXPECT_EQ(toy(other).values, toy().values);
  }
}

TEST(Amc, AsPlainBvhPutsEveryJointInTheSamePlace) {
  const Clip clip = toy();
  const Clip plain = read_bvh(bvh_text(clip), "plain.bvh");
  ASSERT_EQ(plain.skeleton.size(), clip.skeleton.size());
  for (int f = 0; f < clip.frames(); ++f) {
    const WorldPose a = forward_kinematics(clip, f), b = forward_kinematics(plain, f);
    EXPECT_LT((a.positions - b.positions).cwiseAbs().maxCoeff(), 1e-13);
  }
}

// About 90 degrees of Y the angles of Z and X are free; the product must still be right.
TEST(PlainClip, IsRightAtTheSingularAngle) {
  for (const double angle : {90.0, -90.0, 90 - 1e-7, 90 + 1e-9, 270.0}) {
    const std::string turned = "up 10 " + std::to_string(angle) + " 30";
    const Clip clip = toy(replaced(toy_amc, "up 10 20 30", turned));
    const Clip plain = plain_clip(clip);
    const WorldPose a = forward_kinematics(clip, 1), b = forward_kinematics(plain, 1);
    EXPECT_LT((a.positions - b.positions).cwiseAbs().maxCoeff(), 1e-13) << angle;
  }
}

TEST(PlainClip, HasAnglesWithoutJumps) {
  std::string text = ":DEGREES\n";
  for (int f = 0; f < 100; ++f) {
    text += std::to_string(f) + "\nroot 0 0 0 0 " + std::to_string(10 * f) + " 0\nup " +
            std::to_string(8 * f) + " 20 " + std::to_string(-9 * f) + "\narm 0\n";
  }
  const Clip plain = plain_clip(toy(text));
  const Eigen::MatrixXd steps = plain.values.rightCols(99) - plain.values.leftCols(99);
  EXPECT_LT(steps.cwiseAbs().maxCoeff(), 90);
}

struct Broken {
  const char* name;
  std::string text;
  int line, column;
  const char* says;
};

class BrokenAmc : public testing::TestWithParam<Broken> {};

TEST_P(BrokenAmc, IsRefusedWithPlaceAndReason) {
  try {
    read_amc(GetParam().text, "bad.amc", read_asf(toy_asf, "toy.asf"));
    FAIL() << "it was read";
  } catch (const InputError& error) {
    const Problem& first = error.problems().front();
    EXPECT_EQ(first.file, "bad.amc");
    EXPECT_EQ(first.line, GetParam().line) << first.message;
    EXPECT_EQ(first.column, GetParam().column) << first.message;
    EXPECT_NE(first.message.find(GetParam().says), std::string::npos) << first.message;
  }
}

std::vector<Broken> broken_files() {
  const std::string& t = toy_amc;
  return {{"Empty", "", 1, 1, "empty"},
          {"NoFrame", ":FULLY-SPECIFIED\n:DEGREES\n", 2, 1, "no frame"},
          {"OtherFile", "HIERARCHY\n", 1, 1, "number of a frame"},
          {"NoFirstNumber", replaced(t, "\n1\n", "\n"), 4, 1, "number of a frame"},
          {"UnknownBone", replaced(t, "arm 90", "arm 90\nleg 90"), 8, 1, "no bone of toy.asf"},
          {"StiffBone", replaced(t, "arm 90", "arm 90\ntip 1"), 8, 1, "0 degrees of freedom"},
          {"TooFewValues", replaced(t, "up 10 20 30", "up 10 20"), 10, 1, "holds 2 values"},
          {"TooManyValues", replaced(t, "up 10 20 30", "up 10 20 30 40"), 10, 1, "holds 4 values"},
          {"NoValues", replaced(t, "up 10 20 30", "up"), 10, 1, "holds 0 values"},
          {"BoneTwice", replaced(t, "arm -45\n", "arm -45\narm -45\n"), 12, 1, "twice"},
          {"BoneMissing", replaced(t, "up 0 0 0\n", ""), 4, 1, "the frame lacks 'up'"},
          {"CutInFrame", replaced(t, "arm -45\n", ""), 8, 1, "the frame lacks 'arm'"},
          {"NumbersJump", replaced(t, "\n2\n", "\n4\n"), 8, 1, "frame 4 comes after frame 1"},
          {"NumberAgain", replaced(t, "\n2\n", "\n1\n"), 8, 1, "frame 1 comes after frame 1"},
          {"HalfAFrame", replaced(t, "\n2\n", "\n1.5\n"), 8, 1, "number of a frame"},
          {"TextBehindNumber", replaced(t, "\n2\n", "\n2 x\n"), 8, 3, "nothing behind"},
          {"TextInValues", replaced(t, "10 20", "10 x20"), 10, 7, "not a number"},
          {"NotANumber", replaced(t, "10 20", "10 nan"), 10, 7, "not finite"},
          {"Infinite", replaced(t, "10 20", "10 1e999"), 10, 7, "too large"},
          {"NoRate", ":samples-per-second 0\n" + t, 1, 21, "above 0"}};
}

INSTANTIATE_TEST_SUITE_P(Table, BrokenAmc, testing::ValuesIn(broken_files()),
                         [](const auto& instance) { return std::string(instance.param.name); });

std::vector<std::string> all_that_is_wrong(const std::string& text) {
  std::vector<std::string> lines;
  try {
    read_amc(text, "a.amc", read_asf(toy_asf, "toy.asf"));
  } catch (const InputError& error) {
    for (const Problem& problem : error.problems()) lines.push_back(to_text(problem));
  }
  return lines;
}

TEST(Amc, SaysOnceWhatIsWrongInEveryFrameAndInTheOrderOfTheLines) {
  std::string text = replaced(toy_amc, "\narm 90", "\namr 90");
  for (int f = 3; f < 100; ++f) {
    text += std::to_string(f) + "\nroot 5 6 8 0 90 0\nup 1 2 3\namr 90\n";
  }
  EXPECT_EQ(all_that_is_wrong(replaced(text, "10 20", "10 x")),
            (std::vector<std::string>{
                "a.amc:4:1: error: the frame lacks 'arm'; so 97 times more",
                "a.amc:7:1: error: 'amr' is no bone of toy.asf; so 97 times more; did you mean "
                "'arm'?",
                "a.amc:10:7: error: 'x' is not a number"}));
}

TEST(Amc, NamesTheKeywordThatWasMeant) {
  const Clip clip = toy(replaced(toy_amc, ":DEGREES", ":DEGREEES"));
  ASSERT_FALSE(clip.warnings.empty());
  EXPECT_EQ(
      to_text(clip.warnings[0])
          .find(
              "toy_1.amc:3:1: warning: keyword ':DEGREEES' is left out; did you mean ':degrees'?"),
      0u)
      << to_text(clip.warnings[0]);
}

class AmcFolder : public testing::Test {
 protected:
  AmcFolder()
      : folder_(fs::temp_directory_path() / ("promenade_amc_" + std::to_string(::getpid()))) {
    fs::remove_all(folder_);
    write("16_15.amc", toy_amc);
  }
  ~AmcFolder() override { fs::remove_all(folder_); }

  void write(const std::string& name, const std::string& text) { write_file(folder_ / name, text); }

  fs::path folder_;
};

TEST_F(AmcFolder, GivesTheSkeletonOfTheSameName) {
  write("16.asf", toy_asf);
  write("17.asf", "not this one");
  EXPECT_EQ(find_asf(folder_ / "16_15.amc"), folder_ / "16.asf");
  EXPECT_EQ(load_clip(folder_ / "16_15.amc").values, toy().values);
}

TEST_F(AmcFolder, GivesTheOnlySkeleton) {
  write("other.ASF", toy_asf);
  EXPECT_EQ(find_asf(folder_ / "16_15.amc"), folder_ / "other.ASF");
}

TEST_F(AmcFolder, TakesTheLongestNameThatFits) {
  for (const char* name : {"a.asf", "a_b.asf", "c.asf"}) write(name, toy_asf);
  EXPECT_EQ(find_asf(folder_ / "a_b_120.amc"), folder_ / "a_b.asf");
  EXPECT_EQ(find_asf(folder_ / "a_c_120.amc"), folder_ / "a.asf");
}

TEST_F(AmcFolder, WithoutOneSkeletonAsksForIt) {
  EXPECT_THROW(load_clip(folder_ / "16_15.amc"), InputError);
  write("a.asf", toy_asf);
  write("b.asf", toy_asf);
  EXPECT_THROW(load_clip(folder_ / "16_15.amc"), InputError);
  EXPECT_EQ(load_clip(folder_ / "16_15.amc", {folder_ / "b.asf", {}}).values, toy().values);
}

}  // namespace
}  // namespace promenade::motion
