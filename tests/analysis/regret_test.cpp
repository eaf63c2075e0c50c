#include "analysis/regret.h"

#include <gtest/gtest.h>

#include "study/interface.h"
#include "study/stored_study.h"
#include "tests/analysis/toy_log.h"

namespace promenade::analysis {
namespace {

Dataset two_trials() {
  Dataset data;
  data.people = {"P1"};
  data.interfaces = {"labels", "weights"};
  data.tasks = {{"match", {"happy", "sad"}, {}, {}}};
  data.measures = {{"d_final", "final D", "m", "cm", 100, 1}};
  data.trials.push_back({0, 0, 0, 0, 1, "done", false, {0.05}});
  data.trials.push_back({0, 1, 0, 1, 2, "done", false, {0.07}});
  data.trials.push_back({0, 1, 0, 0, 3, "done", false, {std::nullopt}});
  return data;
}

TEST(Regret, IsWhatAPersonLeftOfWhatCanBeReached) {
  Dataset data = two_trials();
  add_regret({{{"match", "happy", "labels", 0.02}, {"match", "happy", "weights", 0.01}}, ""}, data);
  ASSERT_EQ(data.measures.back().name, "regret");
  EXPECT_DOUBLE_EQ(*data.trials[0].values[1], 0.05 - 0.02);
  EXPECT_EQ(data.trials[1].values[1], std::nullopt);  // nobody knows what "sad" allows
  EXPECT_EQ(data.trials[2].values[1], std::nullopt);
}

TEST(Regret, IsNoMeasureWhereNothingCanBeFound) {
  Dataset data = two_trials();
  add_regret({{}, "a reason"}, data);
  EXPECT_EQ(data.measures.size(), 1u);
}

TEST(Regret, SaysThatAStoredStudyCannotBeRead) {
  const TestFolder folder;
  ToyLog log(folder.file("toy.db"));  // its study names no motions
  const study::InterfaceRegistry registry;
  const auto stored = study::read_newest_study(log.database(), registry);
  ASSERT_FALSE(stored);
  const Reachability found = find_reachable(nullptr, registry);
  EXPECT_TRUE(found.rows.empty());
  EXPECT_NE(found.missing.find("cannot read the stored study"), std::string::npos);
}

}  // namespace
}  // namespace promenade::analysis
