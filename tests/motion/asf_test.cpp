#include "motion/asf.h"

#include <gtest/gtest.h>

#include "motion/amc.h"
#include "tests/motion/toy_asf.h"
#include "tests/motion/toy_bvh.h"

namespace promenade::motion {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

Clip toy(const std::string& asf = toy_asf, const std::string& amc = toy_amc) {
  return read_amc(amc, "toy_1.amc", read_asf(asf, "toy.asf"));
}

Vector3d joint_at(const Clip& clip, int frame, const std::string& name) {
  return forward_kinematics(clip, frame).positions.col(find_joint(clip.skeleton, name));
}

Matrix3d about(double degrees, const Vector3d& axis) {
  return Eigen::AngleAxisd(degrees * M_PI / 180, axis).toRotationMatrix();
}

const Vector3d x = Vector3d::UnitX(), y = Vector3d::UnitY(), z = Vector3d::UnitZ();

TEST(Asf, HasAJointAtTheStartOfEveryBoneAndTheRoot) {
  const AsfSkeleton asf = read_asf(toy_asf, "toy.asf");
  ASSERT_EQ(asf.skeleton.size(), 4);
  EXPECT_EQ(asf.skeleton.joints[0].name, "root");
  EXPECT_EQ(asf.skeleton.joints[2].name, "arm");
  EXPECT_EQ(asf.skeleton.joints[2].parent, 1);
  EXPECT_EQ(asf.skeleton.joints[1].offset, Vector3d(0, 0, 0));
  EXPECT_EQ(asf.skeleton.joints[2].offset, Vector3d(0, 3, 0));
  ASSERT_EQ(asf.skeleton.end_sites.size(), 1U);
  EXPECT_EQ(asf.skeleton.end_sites[0].offset, z);
  EXPECT_EQ(asf.rows, 10);
  EXPECT_TRUE(asf.warnings.empty());
}

TEST(Asf, SaysItsUnitWhenItStatesALength) {
  EXPECT_EQ(read_asf(toy_asf, "x").unit_m, 0.0254 / 0.5);
  EXPECT_EQ(read_asf(replaced(toy_asf, "  length 0.5\n", ""), "x").unit_m, std::nullopt);
}

// 90 degrees about the world's y, which is the arm's own x, bring +X to -Z.
TEST(Asf, TurnsABoneAboutItsOwnAxes) {
  const Clip clip = toy();
  EXPECT_TRUE(joint_at(clip, 0, "up").isApprox(Vector3d(5, 6, 7)));
  EXPECT_TRUE(joint_at(clip, 0, "arm").isApprox(Vector3d(5, 9, 7)));
  EXPECT_TRUE(joint_at(clip, 0, "tip").isApprox(Vector3d(5, 9, 5)));
}

TEST(Asf, TurnsAboutFixedAxesInTheOrderOfTheFreedoms) {
  const Matrix3d root = about(90, y), axes = about(90, z);
  const Matrix3d up = root * about(30, z) * about(20, y) * about(10, x);
  const Matrix3d arm = up * axes * about(-45, x) * axes.transpose();
  const Vector3d expected = Vector3d(5, 6, 8) + up * Vector3d(0, 3, 0) + arm * Vector3d(2, 0, 0);
  EXPECT_TRUE(joint_at(toy(), 1, "tip").isApprox(expected, 1e-14));
  const Clip other = toy(replaced(toy_asf, "dof rx ry rz", "dof rz rx ry"));
  const Matrix3d turned = root * about(30, y) * about(20, x) * about(10, z);
  EXPECT_TRUE(joint_at(other, 1, "arm").isApprox(Vector3d(5, 6, 8) + turned * (3 * y), 1e-14));
}

TEST(Asf, TakesTheOrderOfTheAxisFromItsLetters) {
  const Clip clip = toy(replaced(toy_asf, "axis 0 0 90 XYZ", "axis 10 20 30 ZXY"));
  const Matrix3d axes = about(30, y) * about(20, x) * about(10, z);
  const Matrix3d arm = axes * about(90, x) * axes.transpose();
  const Vector3d expected = Vector3d(5, 9, 7) + arm * Vector3d(2, 0, 0);
  EXPECT_TRUE(joint_at(clip, 0, "tip").isApprox(expected, 1e-14));
}

TEST(Asf, MayWriteItsAnglesInRadians) {
  std::string text = replaced(toy_asf, "angle deg", "angle radians");
  text = replaced(text, "axis 0 0 90", "axis 0 0 1.5707963267948966");
  EXPECT_TRUE(joint_at(toy(text), 0, "tip").isApprox(Vector3d(5, 9, 5)));
}

TEST(Asf, MayOrderTheRootInAnyWay) {
  const Clip clip = toy(replaced(toy_asf, "order TX TY TZ RX RY RZ", "order rx ry rz tz ty tx"),
                        replaced(toy_amc, "root 5 6 7 0 0 0", "root 0 0 0 7 6 5"));
  EXPECT_TRUE(joint_at(clip, 0, "tip").isApprox(Vector3d(5, 9, 5)));
}

// What stands in the skeleton comes before the motion, which turns about world axes.
TEST(Asf, MayPlaceTheRootItselfAndWarns) {
  std::string text = replaced(toy_asf, "position 0 0 0", "position 1 2 3");
  text = replaced(text, "orientation 0 0 0", "orientation 90 0 0");
  const Clip clip = toy(text);
  EXPECT_TRUE(joint_at(clip, 0, "up").isApprox(Vector3d(6, 8, 10)));
  EXPECT_TRUE(joint_at(clip, 0, "arm").isApprox(Vector3d(6, 8, 13)));
  EXPECT_TRUE(joint_at(clip, 1, "up").isApprox(Vector3d(6, 8, 11)));
  ASSERT_FALSE(clip.warnings.empty());
  EXPECT_NE(clip.warnings[0].message.find("root"), std::string::npos);
}

TEST(Asf, TakesLineEndsCommentsAndUnknownSections) {
  std::string text = replaced(toy_asf, ":root", ":skin a.obj\n  b c\n:root  # here");
  for (const std::string end : {"\r\n", "\r"}) {
    std::string other;
    for (const char c : text) other += c == '\n' ? end : std::string(1, c);
    const AsfSkeleton asf = read_asf(other, "x");
    EXPECT_EQ(asf.skeleton.size(), 4);
    ASSERT_EQ(asf.warnings.size(), 1U);
    EXPECT_NE(asf.warnings[0].message.find(":skin"), std::string::npos);
  }
}

TEST(Asf, OfAHundredThousandBonesInAChainIsRead) {
  std::string text = ":root\norder TX\n:bonedata\n", lines = ":hierarchy\nbegin\nroot b0\n";
  for (int b = 0; b < 100'000; ++b) {
    text += "begin name b" + std::to_string(b) + "\nlength 1\ndirection 1 0 0\nend\n";
    if (b > 0) lines += "b" + std::to_string(b - 1) + " b" + std::to_string(b) + "\n";
  }
  const AsfSkeleton asf = read_asf(text + lines + "end\n", "x");
  EXPECT_EQ(asf.skeleton.joints.back().name, "b99999");
}

TEST(Asf, NamesTheWordThatWasMeantWhereItGoesOn) {
  std::string text = replaced(toy_asf, "    direction 0 1 0", "    dirction 0 1 0");
  text = replaced(text, "  length 0.5", "  lenght 0.5");
  const AsfSkeleton asf = read_asf(text, "x");
  ASSERT_EQ(asf.warnings.size(), 2U);
  EXPECT_EQ(asf.warnings[0].line, 6);
  EXPECT_NE(asf.warnings[0].message.find("mean 'length'?"), std::string::npos);
  EXPECT_EQ(asf.warnings[1].line, 19);
  EXPECT_NE(asf.warnings[1].message.find("mean 'direction'?"), std::string::npos);
}

struct Broken {
  const char* name;
  std::string text;
  int line, column;
  const char* says;
};

class BrokenAsf : public testing::TestWithParam<Broken> {};

TEST_P(BrokenAsf, IsRefusedWithPlaceAndReason) {
  try {
    read_asf(GetParam().text, "bad.asf");
    FAIL() << "it was read";
  } catch (const InputError& error) {
    const Problem& first = error.problems().front();
    EXPECT_EQ(first.file, "bad.asf");
    EXPECT_EQ(first.line, GetParam().line) << first.message;
    EXPECT_EQ(first.column, GetParam().column) << first.message;
    EXPECT_NE(first.message.find(GetParam().says), std::string::npos) << first.message;
  }
}

std::vector<Broken> broken_files() {
  const std::string& t = toy_asf;
  return {
      {"Empty", "", 1, 1, "empty"},
      {"OnlyComments", "# a\n# b\n", 1, 1, "empty"},
      {"OtherFile", "HIERARCHY\nROOT a\n", 1, 1, "expected a keyword"},
      {"NoRoot", ":version 1\n", 1, 1, "no section :root"},
      {"NoBones", ":root\norder tx\n", 2, 7, "no bones"},
      {"NothingMoves", ":root\n:bonedata\nbegin name a\nend\n:hierarchy\nbegin\nroot a\nend\n", 8,
       1, "nothing can move"},
      {"TextInDirection", replaced(t, "direction 0 1 0", "direction 0 y 0"), 19, 17,
       "not a number"},
      {"TextInLength", replaced(t, "length 3", "length long"), 20, 12, "not a number"},
      {"NoLength", replaced(t, "length 0.5", "length 0"), 6, 10, "above 0"},
      {"OtherAngle", replaced(t, "angle deg", "angle turns"), 7, 9, "deg or rad"},
      {"AxisTwice", replaced(t, "0 0 90 XYZ", "0 0 90 XXZ"), 31, 17, "order of axes"},
      {"NoAxisOrder", replaced(t, "0 0 90 XYZ", "0 0 90"), 32, 5, "order of axes"},
      {"OtherFreedom", replaced(t, "dof rx ry", "dof rx rw"), 22, 12, "degree of freedom"},
      {"FreedomTwice", replaced(t, "dof rx ry", "dof rx rx"), 22, 12, "twice"},
      {"MovingBone", replaced(t, "dof rx ry", "dof rx ty"), 22, 5, "only the root"},
      {"SameName", replaced(t, "name arm", "name UP"), 28, 10, "second bone"},
      {"NamedRoot", replaced(t, "name arm", "name root"), 28, 10, "second bone"},
      {"NoName", replaced(t, "    name arm\n", ""), 32, 3, "without a name"},
      {"CutInBones", t.substr(0, t.find("    dof rx\n  end")), 32, 1, "end of the bone"},
      {"CutInHierarchy", t.substr(0, t.rfind("  end")), 44, 1, "end of the hierarchy"},
      {"NoHierarchy", t.substr(0, t.find(":hierarchy")), 18, 10, "hangs nowhere"},
      {"MisspeltBone", replaced(t, "up arm", "up arn"), 42, 8, "did you mean 'arm'?"},
      {"MisspeltSection", replaced(t, "  axis XYZ", "  axes XYZ"), 12, 3, "mean 'axis'?"},
      {"UnknownBone", replaced(t, "up arm", "up leg"), 42, 8, "no bone"},
      {"TwoParents", replaced(t, "root up", "root up arm"), 42, 8, "second parent"},
      {"RootBelow", replaced(t, "arm tip", "arm root"), 43, 9, "root cannot"},
      {"LooseBone", replaced(t, "    arm tip\n", ""), 35, 10, "hangs nowhere"},
      {"Ring", replaced(t, "root up\n    up arm\n    arm tip", "root up\n    arm tip\n    tip arm"),
       44, 3, "in a ring"}};
}

INSTANTIATE_TEST_SUITE_P(Table, BrokenAsf, testing::ValuesIn(broken_files()),
                         [](const auto& instance) { return std::string(instance.param.name); });

}  // namespace
}  // namespace promenade::motion
