#include <gtest/gtest.h>

#include <cmath>

#include "analysis/statistics/power_paired_t.h"
#include "analysis/statistics/power_sign_flips.h"
#include "analysis/statistics/power_simulated.h"
#include "analysis/statistics/wilcoxon.h"

namespace promenade::analysis {
namespace {

// Of all 2^n sign vectors those that the test itself rejects, each with its probability.
double by_all_signs(int n, double p_plus, double alpha, bool exact) {
  double power = 0;
  for (unsigned signs = 0; signs < 1u << n; ++signs) {
    std::vector<double> d;
    double probability = 1;
    for (int i = 0; i < n; ++i) {
      const bool plus = (signs >> i & 1u) != 0;
      d.push_back(plus ? i + 1 : -i - 1);
      probability *= plus ? p_plus : 1 - p_plus;
    }
    const SignedRankTest test = wilcoxon(d);
    power += (exact ? test.exact->two : test.normal->two) <= alpha ? probability : 0;
  }
  return power;
}

TEST(SignFlipPower, IsThatOfAllSignVectors) {
  for (const int n : {1, 5, 6, 8, 11}) {
    for (const double alpha : {0.05, 0.2, 0.9}) {
      for (const double p : {0.0, 0.5, 0.8, 1.0}) {
        EXPECT_NEAR(sign_flip_power(n, p, critical_rank_sum(n, alpha)),
                    by_all_signs(n, p, alpha, true), 1e-13);
        EXPECT_NEAR(sign_flip_power(n, p, critical_rank_sum_normal(n, alpha)),
                    by_all_signs(n, p, alpha, false), 1e-13);
      }
    }
  }
}

// Tables of the signed-rank test, two-sided at 5 %: n = 6: 0, 10: 8, 20: 52, 25: 89.
TEST(CriticalRankSum, IsThatOfTheTables) {
  EXPECT_FALSE(critical_rank_sum(5, 0.05));
  EXPECT_EQ(critical_rank_sum(6, 0.05), 0);
  EXPECT_EQ(critical_rank_sum(10, 0.05), 8);
  EXPECT_EQ(critical_rank_sum(20, 0.05), 52);
  EXPECT_EQ(critical_rank_sum(25, 0.05), 89);
  EXPECT_EQ(critical_rank_sum(6, 1.0 / 32), 0);  // equal is rejected
  EXPECT_FALSE(critical_rank_sum(6, 1.0 / 33));
}

TEST(CriticalRankSum, OfNoDifferencesIsNone) {
  EXPECT_FALSE(critical_rank_sum(0, 0.999));
  EXPECT_FALSE(critical_rank_sum_normal(0, 0.999));
  EXPECT_EQ(sign_flip_power(0, 0.5, std::nullopt), 0);
}

TEST(SignFlipPower, OfManyDifferencesIsCertain) {
  EXPECT_NEAR(sign_flip_power(500, 0.9, critical_rank_sum(500, 0.05)), 1, 1e-12);
  EXPECT_NEAR(sign_flip_power(500, 0.5, critical_rank_sum(500, 0.05)), 0.05, 1e-4);
}

// Without a shift the power is the attained level, whatever the noise; with one of a size
// that no noise reaches it is 1.
TEST(SimulatedPower, IsKnownWithoutAShiftAndWithAHugeOne) {
  for (const Noise noise : {Noise::normal, Noise::t3, Noise::laplace}) {
    SimulatedStudies studies;
    studies.n = 9;
    studies.noise = noise;
    const double level = sign_flip_power(9, 0.5, critical_rank_sum(9, 0.05));
    const SimulatedPower none = simulated_power(studies);
    EXPECT_NEAR(*none.power, level, 4 * std::sqrt(level * (1 - level) / studies.count));
    EXPECT_NEAR(*none.se, std::sqrt(*none.power * (1 - *none.power) / studies.count), 1e-15);
    studies.shift = -1e6;
    EXPECT_EQ(simulated_power(studies).power, 1.0);
  }
}

// Six differences are rejected where all signs agree: Phi(s)^6 + Phi(-s)^6, and the same with
// the other distributions. t3 / sqrt(3): F(x) = 1/2 + (atan x + x/(1 + x^2))/pi at x = s.
TEST(SimulatedPower, OfSixIsThatAllSignsAgree) {
  const double s = 0.7;
  const double pi = std::acos(-1.0);
  const double above[] = {std::erfc(-s / std::sqrt(2.0)) / 2,
                          0.5 + (std::atan(s) + s / (1 + s * s)) / pi,
                          1 - std::exp(-s * std::sqrt(2.0)) / 2};
  for (const Noise noise : {Noise::normal, Noise::t3, Noise::laplace}) {
    const double p = above[static_cast<int>(noise)];
    const double power = std::pow(p, 6) + std::pow(1 - p, 6);
    const double simulated = *simulated_power({6, s, noise, 0.05, 100000, 3}).power;
    EXPECT_NEAR(simulated, power, 4 * std::sqrt(power * (1 - power) / 100000));
  }
}

TEST(SimulatedPower, IsTheSameForOneSeed) {
  const SimulatedStudies studies = {13, 0.5, Noise::normal, 0.05, 2000, 9};
  EXPECT_EQ(simulated_power(studies).power, simulated_power(studies).power);
}

TEST(SimulatedPower, OfNoStudiesOrNoDifferencesIsNoneOrZero) {
  EXPECT_FALSE(simulated_power({13, 0.5, Noise::normal, 0.05, 0, 1}).power);
  EXPECT_EQ(simulated_power({0, 0.5, Noise::normal, 0.05, 10, 1}).power, 0.0);
  EXPECT_EQ(simulated_power({5, 9, Noise::normal, 0.05, 10, 1}).power, 0.0);
}

// E over the spread s of P(|Z + ncp| > t s), s^2 = chi2 / df, by the trapezoidal rule.
double by_integration(int n, double delta, double t) {
  const double df = n - 1;
  const double ncp = delta * std::sqrt(static_cast<double>(n));
  const double factor = std::log(2) + df / 2 * std::log(df / 2) - std::lgamma(df / 2);
  double power = 0;
  constexpr double step = 1e-4;
  for (double s = step; s < 6; s += step) {
    const double density = std::exp(factor + (df - 1) * std::log(s) - df * s * s / 2);
    const double outside = std::erfc((t * s - ncp) / std::sqrt(2.0)) / 2 +
                           std::erfc((t * s + ncp) / std::sqrt(2.0)) / 2;
    power += step * density * outside;
  }
  return power;
}

TEST(PairedTPower, IsTheIntegralOverTheSpread) {
  constexpr double t12 = 2.178812829663418, t4 = 2.776445105197793;  // tables, 97.5 %
  EXPECT_NEAR(*power_paired_t(13, 0.5, 1, 0.05), by_integration(13, 0.5, t12), 1e-8);
  EXPECT_NEAR(*power_paired_t(13, -1, 2, 0.05), by_integration(13, 0.5, t12), 1e-8);
  EXPECT_NEAR(*power_paired_t(5, 1.5, 1, 0.05), by_integration(5, 1.5, t4), 1e-8);
}

TEST(PairedTPower, WithoutADifferenceIsTheLevel) {
  for (const double alpha : {1e-9, 0.05, 0.999}) {
    EXPECT_NEAR(*power_paired_t(7, 0, 1, alpha), alpha, 1e-12);
  }
}

TEST(PairedTPower, OfFewerThanTwoPairsIsNotDefined) {
  EXPECT_FALSE(power_paired_t(0, 1, 1, 0.05));
  EXPECT_FALSE(power_paired_t(1, 1, 1, 0.05));
}

// One degree of freedom: |t'| > t where |Z + ncp| > t |Z'|; both forms meet at ncp = 10,000.
TEST(PairedTPower, GoesOnWhereBoostEnds) {
  const double delta = 1e4 / std::sqrt(2.0);
  const double before = *power_paired_t(2, delta * (1 - 1e-9), 1, 1e-5);
  EXPECT_NEAR(*power_paired_t(2, delta * (1 + 1e-9), 1, 1e-5), before, 1e-8);
  EXPECT_NEAR(before, std::erf(1e4 * std::tan(std::acos(-1.0) / 2 * 1e-5) / std::sqrt(2.0)), 1e-7);
  EXPECT_EQ(power_paired_t(13, 1e300, 1e-300, 0.05), 1.0);
  EXPECT_EQ(power_paired_t(2000000000, 1e8, 1, 0.05), 1.0);
  EXPECT_NEAR(*power_paired_t(2, 1, 1, 1e-320), 0, 1e-12);
}

}  // namespace
}  // namespace promenade::analysis
