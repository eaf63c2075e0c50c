#include "analysis/power/resampling.h"

#include <gtest/gtest.h>

#include <cmath>

#include "motion/problem.h"

namespace promenade::analysis {
namespace {

// People who did one trial with each interface: values[person][interface].
Dataset people_with(const std::vector<std::vector<double>>& values,
                    const std::vector<std::string>& interfaces = {"first", "second"}) {
  Dataset data;
  data.interfaces = interfaces;
  data.tasks = {{"match", {"happy"}, {}, {}}};
  data.measures = {{"d_final", "final D", "m", "cm", 100, 1}};
  for (const std::vector<double>& person : values) {
    for (std::size_t i = 0; i < person.size(); ++i) {
      Trial trial;
      trial.person = static_cast<int>(data.people.size());
      trial.interface = static_cast<int>(i);
      trial.outcome = "done";
      trial.values = {person[i]};
      data.trials.push_back(trial);
    }
    data.people.push_back("P" + std::to_string(data.people.size()));
  }
  return data;
}

PowerQuestion question(std::vector<int> participants, int studies = 400) {
  PowerQuestion question;
  question.participants = std::move(participants);
  question.studies = studies;
  return question;
}

PowerTable power(const Dataset& pilot, double effect, const PowerQuestion& asked) {
  return resampled_power(pilot, "pilot.db", {"match", "d_final", effect, "", ""}, asked);
}

// The two-sided exact p of at most 10 differences, by writing down all signs.
double brute_p(const std::vector<double>& d) {
  const auto w_plus = [&d](unsigned flips) {
    double sum = 0;
    for (std::size_t i = 0; i < d.size(); ++i) {
      double rank = 0.5;
      for (const double other : d) {
        rank += std::abs(other) < std::abs(d[i]) ? 1 : std::abs(other) == std::abs(d[i]) ? 0.5 : 0;
      }
      sum += (d[i] > 0) != ((flips >> i & 1U) != 0) ? rank : 0;
    }
    return sum;
  };
  int low = 0, high = 0;
  const unsigned all = 1U << d.size();
  for (unsigned flips = 0; flips < all; ++flips) {
    low += w_plus(flips) <= w_plus(0) ? 1 : 0;
    high += w_plus(flips) >= w_plus(0) ? 1 : 0;
  }
  return std::min(1.0, 2.0 * std::min(low, high) / all);
}

TEST(ResampledPower, IsOneAsSoonAsTheTestCanRejectALargeEffect) {
  const Dataset pilot = people_with({{1, 2}, {3, 5}, {2, 1}, {4, 3}});
  const PowerTable table = power(pilot, 100, question({5, 6}));
  ASSERT_EQ(table.rows.size(), 2U);
  EXPECT_EQ(table.rows[0].holm.share(), 0);  // the smallest p of five people is .0625
  EXPECT_EQ(table.rows[1].holm.share(), 1);
  EXPECT_NEAR(table.rows[1].hl.value(), 100, 2);
}

// Differences -3 and 3 around 0; with an effect of 1 they are -2 and 4: all draws of seven.
TEST(ResampledPower, AgreesWithAllDrawsWrittenDown) {
  const Dataset pilot = people_with({{5, 0}, {-1, 0}});  // 5 and -1: 2 apart from their middle
  double exact = 0;
  for (unsigned draw = 0; draw < 128; ++draw) {
    std::vector<double> d;
    for (unsigned i = 0; i < 7; ++i) d.push_back((draw >> i & 1U) != 0 ? 4 : -2);
    exact += brute_p(d) <= 0.05 ? 1.0 / 128 : 0;
  }
  const Rate rate = power(pilot, 1, question({7}, 20'000)).rows[0].holm;
  EXPECT_NEAR(rate.share(), exact, 4 * std::sqrt(exact * (1 - exact) / 20'000));
}

TEST(ResampledPower, WithAnEffectThatIsNextToNothingIsTheSizeOfTheTest) {
  std::vector<std::vector<double>> people;
  for (int i = 0; i < 60; ++i) people.push_back({std::sin(i * i) + 0.001 * i, 0});
  for (int i = 0; i < 60; ++i) people.push_back({-people[static_cast<std::size_t>(i)][0], 0});
  const Rate rate = power(people_with(people), 1e-9, question({13}, 4000)).rows[0].alone;
  // Repeated people are ties, which move the attainable size a little away from .0479.
  EXPECT_NEAR(rate.share(), 0.0479, 0.002 + 4 * std::sqrt(0.0479 * 0.9521 / 4000));
}

TEST(ResampledPower, DoesNotDependOnThreads) {
  const Dataset pilot = people_with({{1, 2, 4}, {3, 5, 1}, {2, 1, 1.5}, {4, 3, 3.2}, {2, 6, 7}},
                                    {"first", "second", "third"});
  PowerQuestion one = question({8, 12});
  PowerQuestion three = one;
  one.threads = 1;
  three.threads = 3;
  const PowerTable a = power(pilot, 1, one);
  const PowerTable b = power(pilot, 1, three);
  ASSERT_EQ(a.rows.size(), 6U);
  for (std::size_t i = 0; i < a.rows.size(); ++i) {
    EXPECT_EQ(a.rows[i].holm.found, b.rows[i].holm.found);
    EXPECT_EQ(a.rows[i].hl, b.rows[i].hl);
    EXPECT_LE(a.rows[i].holm.found, a.rows[i].alone.found);
  }
}

TEST(ResampledPower, TakesAPairInEitherOrder) {
  const Dataset pilot = people_with({{1, 2}, {3, 5}, {2, 1}, {4, 3}, {2, 6}});
  const auto hl = [&](const std::string& a, const std::string& b) {
    return resampled_power(pilot, "pilot.db", {"match", "d_final", 10, a, b}, question({8}))
        .rows[0]
        .hl.value();
  };
  EXPECT_NEAR(hl("first", "second"), 10, 1);
  EXPECT_NEAR(hl("second", "first"), -10, 1);
}

TEST(ResampledPower, NamesWhatThePilotHasInPlaceOfWhatItHasNot) {
  const Dataset pilot = people_with({{1, 2}, {3, 5}});
  for (const SmallestEffect& wrong :
       {SmallestEffect{"find", "d_final", 1, "", ""}, SmallestEffect{"match", "clicks", 1, "", ""},
        SmallestEffect{"match", "d_final", 1, "third", "first"}}) {
    EXPECT_THROW(resampled_power(pilot, "pilot.db", wrong, question({8})), InputError);
  }
  EXPECT_THROW(power(people_with({{1, 2}}), 1, question({8})), InputError);
}

TEST(ResampledPower, OfAPilotInWhichAllIsEqualIsStillANumber) {
  const Dataset pilot = people_with({{1, 1}, {2, 2}, {3, 3}});
  const PowerRow row = power(pilot, 1, question({8})).rows[0];
  EXPECT_EQ(row.holm.share(), 1);  // nobody differs from the effect
  EXPECT_FALSE(row.paired_t);
}

}  // namespace
}  // namespace promenade::analysis
