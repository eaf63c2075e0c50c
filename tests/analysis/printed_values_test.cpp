// What [O] 6 and [N] 6 printed, and the conventions behind it.
#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "analysis/preference.h"
#include "analysis/published/printed.h"
#include "analysis/statistics/wilcoxon.h"
#include "study/published.h"

namespace promenade::analysis {
namespace {

constexpr int n = 13;

// Of single targets.
std::vector<PrintedTest> printed(std::string_view measure) {
  std::vector<PrintedTest> tests;
  for (const PrintedTest& one : printed_study("oshita-2018")->tests) {
    if (one.measure == measure && one.target > 0) tests.push_back(one);
  }
  return tests;
}

int thousandths(double p) { return static_cast<int>(std::lround(1000 * p)); }

// n untied differences whose positive ranks sum to `w`: the largest ranks first.
std::vector<double> differences_with(int w) {
  std::vector<double> d;
  for (int rank = n; rank >= 1; --rank) {
    d.push_back(rank <= w ? rank : -rank);
    if (rank <= w) w -= rank;
  }
  return d;
}

// The p, in thousandths, of every W+ that 13 untied differences can have.
template <typename P>
std::set<int> attainable(P p) {
  std::set<int> values;
  for (int w = 0; w <= n * (n + 1) / 2; ++w) {
    const SignedRankTest test = wilcoxon(differences_with(w));
    EXPECT_EQ(test.w_plus, w);
    values.insert(thousandths(p(test)));
  }
  return values;
}

int how_many_of_the_printed(const std::set<int>& values) {
  int count = 0;
  for (const PrintedTest& one : printed("d_final")) {
    count += static_cast<int>(values.count(thousandths(one.p)));
  }
  return count;
}

std::set<int> normal() {
  return attainable([](const SignedRankTest& test) { return test.normal->two; });
}

TEST(PrintedValues, AreAllAttainableByTheNormalApproximationWithoutCorrection) {
  EXPECT_EQ(how_many_of_the_printed(normal()), 15);
}

TEST(PrintedValues, AreRarelyAttainableByTheExactTest) {
  EXPECT_EQ(how_many_of_the_printed(
                attainable([](const SignedRankTest& test) { return test.exact->two; })),
            6);
}

TEST(PrintedValues, AreRarelyAttainableWithContinuityCorrection) {
  EXPECT_LT(how_many_of_the_printed(
                attainable([](const SignedRankTest& test) { return test.normal_corrected->two; })),
            15);
}

TEST(PrintedValues, OfTimesNeedTiesWhereTheTableSaysSo) {
  const std::set<int> values = normal();
  int need = 0;
  for (const PrintedTest& one : printed("time_s")) {
    EXPECT_EQ(values.count(thousandths(one.p)) == 0, one.needs_ties) << one.p;
    need += one.needs_ties ? 1 : 0;
  }
  EXPECT_EQ(printed("time_s").size(), 15U);
  EXPECT_EQ(need, 5);
}

TEST(PrintedValues, OfThePreferenceFollowFrom14Of17) {
  for (const char* name : {"normoyle-untimed", "normoyle-timed"}) {
    const PrintedPreference& one = *printed_study(name)->preference;
    std::vector<std::string> chosen(static_cast<std::size_t>(one.chosen), "map");
    chosen.resize(static_cast<std::size_t>(one.answers), "labels");
    const Preference preference = preference_of({"map", "labels"}, chosen);
    EXPECT_NEAR(preference.pairs[0].p, one.p, 0.00005);
    EXPECT_NEAR(preference.intervals[0].lower, one.lower, 0.0005);
    EXPECT_NEAR(preference.intervals[0].upper, one.upper, 0.0005);
  }
}

double count_of(const char* study, Quantity quantity) {
  for (const PrintedCount& one : printed_study(study)->counts) {
    if (one.quantity == quantity) return one.value;
  }
  return -1;
}

TEST(PrintedValues, OfKeptPairsAreThoseOfTheTables) {
  for (const char* name : {"oshita-questionnaire-a", "oshita-questionnaire-b"}) {
    int kept = 0;
    std::set<motion::AdjectivePair::Cluster> clusters;
    for (const motion::AdjectivePair& pair : motion::adjective_pairs) {
      const auto cluster = pair.*(printed_study(name)->clusters);
      if (cluster == motion::AdjectivePair::Cluster::none) continue;
      ++kept;
      clusters.insert(cluster);
    }
    EXPECT_EQ(kept, count_of(name, Quantity::kept_pairs)) << name;
    EXPECT_EQ(static_cast<double>(clusters.size()), count_of(name, Quantity::clusters)) << name;
    EXPECT_EQ(count_of(name, Quantity::rated_pairs),
              static_cast<double>(motion::adjective_pairs.size()));
  }
}

TEST(PrintedStudies, AreKnownForEachNameThatAStudyCanSay) {
  for (const std::string& name : study::published_studies()) {
    ASSERT_NE(printed_study(name), nullptr) << name;
    EXPECT_EQ(printed_study(name)->name, name);
    EXPECT_FALSE(printed_study(name)->counts.empty()) << name;
  }
  EXPECT_EQ(printed_study(""), nullptr);
  EXPECT_EQ(printed_study("oshita-2017"), nullptr);
}

}  // namespace
}  // namespace promenade::analysis
