#include "tests/motion/captures.h"

#include <set>

#include "motion/load_clip.h"
#include "motion/set_builder.h"

namespace promenade::motion {
namespace {

namespace fs = std::filesystem;

// dataset-1_walk_happy_001.bvh and so on: fifteen styles, two takes each.
std::vector<TakeSource> walks() {
  const std::string before = "dataset-1_walk_";
  std::vector<TakeSource> takes;
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(data_folder() / "bandai-namco-walk", error)) {
    const std::string name = entry.path().filename().string();
    if (entry.path().extension() != ".bvh" || name.rfind(before, 0) != 0) continue;
    const std::string style =
        name.substr(before.size(), name.find('_', before.size()) - before.size());
    takes.push_back({entry.path().string(), name, style});
  }
  return takes;
}

// Of one actor, by Bandai Namco.
class CapturedWalks : public Captures {
 protected:
  void SetUp() override {
    Captures::SetUp();
    if (!IsSkipped() && walks().empty()) GTEST_SKIP() << "There are no walks of Bandai Namco.";
  }
  // Built once: it takes a second or two.
  static const BuiltSet& built() {
    static const BuiltSet set = build_set(walks(), {});
    return set;
  }
  static std::vector<CycleReport> cut() {
    std::vector<CycleReport> reports;
    for (const CycleReport& report : built().reports) {
      if (!report.cycle.empty()) reports.push_back(report);
    }
    return reports;
  }
};

TEST_F(CapturedWalks, GiveACycleFromNearlyEveryTake) {
  EXPECT_GE(15 * built().set.size(), 14 * static_cast<int>(walks().size()));
  for (const CycleReport& report : built().reports) EXPECT_EQ(report.refusal, "") << report.file;
}

TEST_F(CapturedWalks, GiveCyclesNamedByTheirStyles) {
  std::set<std::string> names;
  for (const Cycle& cycle : built().set.cycles) {
    EXPECT_TRUE(names.insert(cycle.name).second) << cycle.name;
    EXPECT_EQ(cycle.name.rfind(cycle.style + "_", 0), 0U) << cycle.name;
    EXPECT_NE(cycle.source.find("_" + cycle.style + "_"), std::string::npos) << cycle.source;
  }
}

TEST_F(CapturedWalks, GiveFeetThatStand) {
  for (const CycleReport& report : cut()) {
    EXPECT_LT(std::max(report.slide_left_m, report.slide_right_m), 0.008) << report.cycle;
  }
}

TEST_F(CapturedWalks, GiveFeetThatStayAboveTheFloor) {
  for (const Cycle& cycle : built().set.cycles) {
    EXPECT_LT(penetration_m(built().set, cycle), 0.003) << cycle.name;
  }
}

TEST_F(CapturedWalks, CloseNoWorseThanTheyMoveElsewhere) {
  for (const CycleReport& report : cut()) {
    EXPECT_LT(report.seam.position_m, 1e-4) << report.cycle;
    EXPECT_LT(report.seam.gap_m, report.seam.inside_m) << report.cycle;
  }
}

TEST_F(CapturedWalks, GiveStepsInTurnAtTheSpeedOfAWalk) {
  for (const Cycle& cycle : built().set.cycles) {
    ASSERT_EQ(cycle.keytimes.size(), 5U);
    EXPECT_TRUE(std::is_sorted(cycle.keytimes.begin(), cycle.keytimes.end())) << cycle.name;
    EXPECT_GT(cycle.seconds, 0.6) << cycle.name;
    EXPECT_LT(cycle.seconds, 2.5) << cycle.name;
    EXPECT_GT(cycle.velocity.y(), 0.3) << cycle.name;
    EXPECT_LT(cycle.velocity.y(), 2.5) << cycle.name;
  }
}

TEST_F(CapturedWalks, StayWhereTheyWereRecorded) {
  for (const CycleReport& report : cut()) {
    const Cycle& cycle =
        built().set.cycles[static_cast<std::size_t>(find_cycle(built().set, report.cycle))];
    EXPECT_LT(report.from_capture_m, 0.08 + 2 * cycle.loop_error_m) << report.cycle;
  }
}

// The BVH was made from the AMC by others; a T-pose stands before it. Values have six
// digits there and four decimals here.
TEST_F(Captures, OfOneTakeAgreeAsAmcAndAsBvh) {
  const fs::path folder = data_folder() / "cmu";
  if (!fs::exists(folder / "01_01.amc")) GTEST_SKIP() << "There is no 01_01.amc in " << folder;
  const Clip amc = load_clip(folder / "01_01.amc"), bvh = load_clip(folder / "01_01.bvh");
  ASSERT_EQ(amc.frames() + 1, bvh.frames());
  const std::pair<const char*, const char*> same[] = {
      {"root", "Hips"},      {"lfemur", "LeftUpLeg"},   {"ltibia", "LeftLeg"},
      {"lfoot", "LeftFoot"}, {"rtibia", "RightLeg"},    {"rtoes", "RightToeBase"},
      {"thorax", "Spine1"},  {"lowerback", "LowerBack"}};
  for (int f = 0; f < amc.frames(); f += 250) {
    const WorldPose a = forward_kinematics(amc, f), b = forward_kinematics(bvh, f + 1);
    for (const auto& [bone, joint] : same) {
      const Eigen::Vector3d apart = a.positions.col(find_joint(amc.skeleton, bone)) -
                                    b.positions.col(find_joint(bvh.skeleton, joint));
      EXPECT_LT(apart.norm(), 1e-3) << bone << " in frame " << f;
    }
  }
}

// Trials of the CMU database that are there: 07_01-walk.bvh is one of subject 07.
std::vector<TakeSource> trials(const std::vector<std::string>& names) {
  std::vector<TakeSource> takes;
  for (const std::string& name : names) {
    const fs::path file = data_folder() / "cmu" / name;
    if (fs::exists(file)) takes.push_back({file.string(), name, name.substr(0, 6)});
  }
  return takes;
}

void expect_clean(const BuiltSet& built) {
  for (const CycleReport& report : built.reports) {
    EXPECT_EQ(report.refusal, "") << report.file;
    EXPECT_LT(std::max(report.slide_left_m, report.slide_right_m), 0.008) << report.cycle;
    EXPECT_LT(report.seam.gap_m, report.seam.inside_m) << report.cycle;
  }
  for (const Cycle& cycle : built.set.cycles) {
    EXPECT_LT(penetration_m(built.set, cycle), 0.005) << cycle.name;
    EXPECT_LT(std::abs(cycle.origin.turn), 0.2) << cycle.name;
  }
}

TEST_F(Captures, OfSeveralPeopleBecomeOneSet) {
  const auto takes = trials({"02_01-walk.bvh", "07_01-walk.bvh", "142_08-walk_happy.bvh"});
  if (takes.empty()) GTEST_SKIP() << "There are no captures of CMU.";
  const BuiltSet built = build_set(takes, {});
  EXPECT_EQ(built.set.size(), static_cast<int>(takes.size()));
  expect_clean(built);
}

TEST_F(Captures, InTwoFilesBecomeASet) {
  const auto takes = trials({"16_15.amc", "16_32.amc"});
  if (takes.empty()) GTEST_SKIP() << "There are no captures in AMC files.";
  const BuiltSet built = build_set(takes, {});
  EXPECT_EQ(built.set.size(), static_cast<int>(takes.size()));
  expect_clean(built);
}

TEST_F(Captures, ThatWalkInCurvesGiveTheirStraightCycles) {
  const fs::path file = data_folder() / "100style" / "angry_reference.bvh";
  if (!fs::exists(file)) GTEST_SKIP() << "There is no capture " << file << ".";
  const BuiltSet built = build_set({{file.string(), "angry.bvh", "angry"}}, {});
  ASSERT_EQ(built.set.size(), 1);
  EXPECT_GE(built.set.cycles[0].origin.cycles_found, 10);
  expect_clean(built);
}

TEST_F(Captures, OfOtherThingsThanWalkingAreRefused) {
  const fs::path jumps = data_folder() / "cmu" / "01_01.bvh";
  if (!fs::exists(jumps)) GTEST_SKIP() << "There is no capture " << jumps << ".";
  EXPECT_THROW(build_set({{jumps.string(), "01_01.bvh", "jumps"}}, {}), InputError);
}

}  // namespace
}  // namespace promenade::motion
