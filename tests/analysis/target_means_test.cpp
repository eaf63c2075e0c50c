#include "analysis/target_means.h"

#include <gtest/gtest.h>

#include <cmath>

namespace promenade::analysis {
namespace {

Trial trial(int person, int interface, int target, double value) {
  Trial one;
  one.person = person;
  one.interface = interface;
  one.target = target;
  one.values = {value};
  return one;
}

Dataset two_by_two() {
  Dataset data;
  data.people = {"P1", "P2", "P3"};
  data.interfaces = {"blend weights", "labels"};
  data.tasks = {{"match", {"happy", "sad"}, {}, {}}};
  data.measures = {{"d_final", "final D", "m", "cm", 100, 1}};
  data.trials = {trial(0, 0, 0, 1), trial(0, 0, 1, 3), trial(0, 1, 0, 5), trial(0, 1, 1, 7),
                 trial(1, 0, 0, 2), trial(1, 1, 0, 4), trial(2, 0, 1, 10)};
  return data;
}

TEST(TargetMeans, AreOverPeopleTargetByTargetThenOverTheirMeans) {
  const auto means = target_means(two_by_two(), 0, 0);
  ASSERT_EQ(means.size(), 6U);
  EXPECT_EQ(means[0].n, 2);
  EXPECT_EQ(means[0].mean, 1.5);
  EXPECT_DOUBLE_EQ(*means[0].sd, std::sqrt(0.5));
  EXPECT_EQ(means[2].mean, 6.5) << "3 and 10, weights on sad";
  EXPECT_FALSE(means[3].sd) << "one person alone";
  EXPECT_EQ(means[4].target, -1);
  EXPECT_DOUBLE_EQ(means[4].mean, (2 + 2 + 10) / 3.0);
}

TEST(MeanDifferences, PairTheSamePerson) {
  const auto differences = mean_differences(two_by_two(), 0, 0, 0);
  ASSERT_EQ(differences.size(), 3U);
  EXPECT_EQ(differences[0].interface, 1);
  EXPECT_EQ(differences[0].n, 2);
  EXPECT_EQ(differences[0].mean, 3) << "4 and 2";
  // qt(0.95, 1) = 6.313751514675043, sd = sqrt(2), n = 2.
  EXPECT_NEAR(differences[0].interval->upper, 3 + 6.313751514675043, 1e-9);
  EXPECT_FALSE(differences[1].interval) << "one pair";
}

TEST(ReferenceInterface, IsTheBlendWeightsElseTheLast) {
  Dataset data = two_by_two();
  EXPECT_EQ(reference_interface(data, 0), 0);
  data.interfaces = {"map", "labels"};
  EXPECT_EQ(reference_interface(data, 0), 1);
  data.trials.resize(2);
  EXPECT_EQ(reference_interface(data, 0), -1);
}

}  // namespace
}  // namespace promenade::analysis
