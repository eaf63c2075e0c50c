#include "motion/body_mapping.h"

#include <gtest/gtest.h>

#include "motion/body_names.h"
#include "tests/motion/walker.h"

namespace promenade::motion {
namespace {

Clip walker() {
  const MotionSet set = builtin_set("A").value();
  return walker_clip(set, set.cycles[0], 3);
}

// The names of hip, knee, ankle, toe, clavicle, shoulder, elbow and wrist on the left,
// and of those on the right, as one laboratory writes them.
struct Convention {
  const char* name;
  std::array<std::string, 16> sides;
};

class NameConventions : public testing::TestWithParam<Convention> {};

TEST_P(NameConventions, AreUnderstood) {
  Skeleton skeleton;
  skeleton.joints.push_back({"root", -1, {}});
  for (const std::string& name : GetParam().sides) skeleton.joints.push_back({name, 0, {}});
  const NamedJoints found = joints_by_name(skeleton);
  const std::array<int, 8> order = {left_hip,      left_knee,     left_ankle, left_toe,
                                    left_clavicle, left_shoulder, left_elbow, left_wrist};
  for (std::size_t i = 0; i < 8; ++i) {
    const auto part = static_cast<std::size_t>(order[i]);
    EXPECT_EQ(found[part], static_cast<int>(i) + 1) << GetParam().sides[i];
    EXPECT_EQ(found[part + 4], static_cast<int>(i) + 9) << GetParam().sides[i + 8];
  }
}

std::vector<Convention> conventions() {
  return {
      {"Bandai",
       {"UpperLeg_L", "LowerLeg_L", "Foot_L", "Toes_L", "Shoulder_L", "UpperArm_L", "LowerArm_L",
        "Hand_L", "UpperLeg_R", "LowerLeg_R", "Foot_R", "Toes_R", "Shoulder_R", "UpperArm_R",
        "LowerArm_R", "Hand_R"}},
      {"Cmu",
       {"LeftUpLeg", "LeftLeg", "LeftFoot", "LeftToeBase", "LeftShoulder", "LeftArm", "LeftForeArm",
        "LeftHand", "RightUpLeg", "RightLeg", "RightFoot", "RightToeBase", "RightShoulder",
        "RightArm", "RightForeArm", "RightHand"}},
      {"Asf",
       {"lfemur", "ltibia", "lfoot", "ltoes", "lclavicle", "lhumerus", "lradius", "lwrist",
        "rfemur", "rtibia", "rfoot", "rtoes", "rclavicle", "rhumerus", "rradius", "rwrist"}},
      {"HundredStyle",
       {"LeftHip", "LeftKnee", "LeftAnkle", "LeftToe", "LeftCollar", "LeftShoulder", "LeftElbow",
        "LeftWrist", "RightHip", "RightKnee", "RightAnkle", "RightToe", "RightCollar",
        "RightShoulder", "RightElbow", "RightWrist"}},
      {"Mixamo",
       {"mixamorig:LeftUpLeg", "mixamorig:LeftLeg", "mixamorig:LeftFoot", "mixamorig:LeftToeBase",
        "mixamorig:LeftShoulder", "mixamorig:LeftArm", "mixamorig:LeftForeArm",
        "mixamorig:LeftHand", "mixamorig:RightUpLeg", "mixamorig:RightLeg", "mixamorig:RightFoot",
        "mixamorig:RightToeBase", "mixamorig:RightShoulder", "mixamorig:RightArm",
        "mixamorig:RightForeArm", "mixamorig:RightHand"}},
      {"Motive",
       {"Skeleton 001:LThigh", "Skeleton 001:LShin", "Skeleton 001:LFoot", "Skeleton 001:LToe",
        "Skeleton 001:LShoulder", "Skeleton 001:LUArm", "Skeleton 001:LFArm", "Skeleton 001:LHand",
        "Skeleton 001:RThigh", "Skeleton 001:RShin", "Skeleton 001:RFoot", "Skeleton 001:RToe",
        "Skeleton 001:RShoulder", "Skeleton 001:RUArm", "Skeleton 001:RFArm",
        "Skeleton 001:RHand"}}};
}

INSTANTIATE_TEST_SUITE_P(Table, NameConventions, testing::ValuesIn(conventions()),
                         [](const auto& instance) { return std::string(instance.param.name); });

TEST(NamesTheHips, InAnySpelling) {
  for (const char* name : {"Hips", "hips", "pelvis", "mixamorig:Hips", "Skeleton 001:Hips"}) {
    EXPECT_TRUE(names_the_hips(name)) << name;
  }
  for (const char* name : {"LeftHip", "LHipJoint", "Ball", ""}) {
    EXPECT_FALSE(names_the_hips(name)) << name;
  }
}

TEST(FindFigure, SeesUnitHeadingAndTravel) {
  const Figure figure = find_figure(walker());
  EXPECT_EQ(figure.unit_m, 1);
  EXPECT_FALSE(figure.z_up);
  EXPECT_NEAR(figure.heading.y(), 1, 1e-3);
  const MotionSet set = builtin_set("A").value();
  const Cycle& cycle = set.cycles[0];
  EXPECT_NEAR(figure.travel_m, 3 * cycle.seconds * cycle.velocity.norm(), 1e-9);
}

// Every length in centimetres, Z up, walking along -Y.
TEST(FindFigure, SeesCentimetresAndZUp) {
  Clip clip = walker();
  for (Joint& joint : clip.skeleton.joints) joint.offset *= 100;
  for (int f = 0; f < clip.frames(); ++f) {
    const Eigen::Vector3d at = 100 * clip.values.col(f).head<3>();
    clip.values.col(f).head<3>() << at.x(), -at.z(), at.y();
  }
  // A parent joint turns the figure; the rest of it stays.
  clip.skeleton.joints.insert(clip.skeleton.joints.begin(), {"world", -1, {0, 0, 0}});
  for (std::size_t j = 1; j < clip.skeleton.joints.size(); ++j) ++clip.skeleton.joints[j].parent;
  clip.skeleton.end_sites.clear();
  const auto rows = static_cast<int>(clip.values.rows());
  clip.values.conservativeResize(rows + 1, Eigen::NoChange);
  clip.values.row(rows).setConstant(90);
  for (int f = 0; f < clip.frames(); ++f) {
    const Eigen::Vector3d at = clip.values.col(f).head<3>();
    clip.values.col(f).head<3>() << at.x(), at.z(), -at.y();
  }
  clip.channels.insert(clip.channels.begin(), {{Channel::x_rotation}, rows});
  const Figure figure = find_figure(clip);
  EXPECT_TRUE(figure.z_up);
  EXPECT_EQ(figure.unit_m, 0.01);
  EXPECT_NEAR(figure.heading.y(), 1, 1e-3);
}

TEST(FindFigure, TellsPartsByTheTreeWhenNamesSayNothing) {
  Clip clip = walker();
  const Figure named = find_figure(clip);
  for (std::size_t j = 0; j < clip.skeleton.joints.size(); ++j) {
    clip.skeleton.joints[j].name = "bone" + std::to_string(j);
  }
  const Figure told = find_figure(clip);
  for (const BodyJoint part : {pelvis, left_hip, left_knee, left_ankle, left_toe, right_hip,
                               right_knee, right_ankle, right_toe, left_elbow, right_elbow}) {
    EXPECT_EQ(told.body.joint[part], named.body.joint[part]) << body_joint_name(part);
  }
}

TEST(FindFigure, RefusesWhatHasNoLegs) {
  Clip clip = walker();
  clip.skeleton.joints.resize(2);
  clip.channels.resize(2);
  clip.skeleton.end_sites.clear();
  EXPECT_THROW(find_figure(clip), InputError);
}

TEST(MakeTake, FoldsWhatIsAboveTheHips) {
  Clip clip = walker();
  const Take plain = make_take(clip, find_figure(clip));
  clip.skeleton.joints.insert(clip.skeleton.joints.begin(), {"world", -1, {0, 0, 0}});
  for (std::size_t j = 1; j < clip.skeleton.joints.size(); ++j) ++clip.skeleton.joints[j].parent;
  for (EndSite& site : clip.skeleton.end_sites) ++site.joint;
  clip.channels.insert(clip.channels.begin(), {{}, 0});
  const Take folded = make_take(clip, find_figure(clip));
  EXPECT_EQ(folded.skeleton.size(), plain.skeleton.size());
  EXPECT_EQ(folded.body.joint, plain.body.joint);
  EXPECT_TRUE(body_at(folded, 7.5).isApprox(body_at(plain, 7.5), 1e-12));
}

}  // namespace
}  // namespace promenade::motion
