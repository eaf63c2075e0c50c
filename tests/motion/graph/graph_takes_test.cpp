#include "motion/graph/graph_takes.h"

#include <gtest/gtest.h>

#include "motion/builtin.h"
#include "motion/bvh.h"
#include "motion/files.h"
#include "motion/take_clip.h"
#include "tests/motion/walker.h"
#include "tests/test_folder.h"

namespace promenade::motion {
namespace {

const MotionSet& set_a() {
  static const MotionSet set = *builtin_set("A");
  return set;
}

class GraphTakesOfFiles : public testing::Test {
 protected:
  TakeSource written(const std::string& name, const Clip& clip) {
    const std::string file = folder_.file(name + ".bvh");
    write_file(file, bvh_text(clip));
    TakeSource source;
    source.file = file;
    source.label = name;
    source.style = name;
    source.figure.unit_m = 1;
    return source;
  }
  Clip walker(int cycle) const {
    return walker_clip(set_a(), set_a().cycles.at(static_cast<std::size_t>(cycle)), 3);
  }
  std::string trouble_with(const std::vector<TakeSource>& sources) {
    try {
      load_graph_takes(sources, {});
    } catch (const InputError& error) {
      return error.what();
    }
    return "";
  }

  TestFolder folder_;
};

TEST_F(GraphTakesOfFiles, OtherRatesAreRefusedUnlessOneIsAskedFor) {
  Clip slow = walker(0), fast = walker(1);
  slow.frame_time = fast.frame_time = 1.0 / 60;
  slow.frame_time *= 2;
  const std::vector<TakeSource> sources = {written("slow", slow), written("fast", fast)};
  EXPECT_NE(trouble_with(sources).find("has 30 frames a second"), std::string::npos);
  GraphTakeOptions options;
  options.rate = 60;
  const GraphTakes takes = load_graph_takes(sources, options);
  ASSERT_EQ(takes.takes.size(), 2U);
  EXPECT_EQ(takes.takes[0].label, "fast");
  EXPECT_EQ(takes.takes[1].take.frames(), 2 * slow.frames() - 1);
  EXPECT_NEAR(takes.takes[1].take.frame_time, 1.0 / 60, 1e-12);
}

TEST_F(GraphTakesOfFiles, AnotherSkeletonIsRefusedByTheNamesOfItsJoints) {
  Clip one = walker(0), other = walker(1);
  one.frame_time = other.frame_time = 1.0 / 60;
  for (Joint& joint : other.skeleton.joints) {
    if (joint.name == "left_knee") joint.name = "left_lower_leg";
  }
  EXPECT_NE(trouble_with({written("one", one), written("other", other)}).find("left_knee"),
            std::string::npos);
}

TEST_F(GraphTakesOfFiles, AllProblemsOfAllFilesComeAtOnce) {
  TakeSource missing;
  missing.file = folder_.file("nowhere.bvh");
  TakeSource broken;
  broken.file = folder_.file("broken.bvh");
  write_file(broken.file, "no capture at all");
  const std::string trouble = trouble_with({missing, broken});
  EXPECT_NE(trouble.find("nowhere.bvh"), std::string::npos);
  EXPECT_NE(trouble.find("broken.bvh"), std::string::npos);
}

TEST_F(GraphTakesOfFiles, AllStandOnOneFloor) {
  Clip low = walker(0), high = walker(0);
  high.values.row(1).array() += 0.2;
  const GraphTakes takes = load_graph_takes({written("high", high), written("low", low)}, {});
  for (int f = 0; f < low.frames(); f += 10) {
    EXPECT_NEAR(takes.takes[0].take.poses[static_cast<std::size_t>(f)].root.y(),
                takes.takes[1].take.poses[static_cast<std::size_t>(f)].root.y(), 1e-9);
  }
}

TEST(GraphTakes, OfASetWalkEachCycleAFewTimes) {
  const std::vector<GraphTake> takes = takes_of_set(set_a(), 60, 2);
  ASSERT_EQ(takes.size(), set_a().cycles.size());
  const Cycle& cycle = set_a().cycles[0];
  const Take& take = takes[0].take;
  EXPECT_EQ(takes[0].label, cycle.style);
  const double seconds = (take.frames() - 1) / 60.0;
  EXPECT_NEAR(seconds, 2 * cycle.seconds, 1 / 60.0);
  const double travelled = take.poses.back().root.z() - take.poses.front().root.z();
  EXPECT_NEAR(travelled, seconds * cycle.velocity.y(), 0.1);  // beside its sway
}

}  // namespace
}  // namespace promenade::motion
