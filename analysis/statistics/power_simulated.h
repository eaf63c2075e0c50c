// The power of the two-sided exact signed-rank test, by drawing studies.
#pragma once

#include <cstdint>
#include <optional>

namespace promenade::analysis {

// Of mean 0 and standard deviation 1: normal; Student's t with 3 degrees of freedom / sqrt(3);
// Laplace with scale 1 / sqrt(2).
enum class Noise { normal, t3, laplace };

struct SimulatedStudies {
  int n = 0;         // differences in each, at most sign_flips_limit
  double shift = 0;  // of their mean, in standard deviations
  Noise noise = Noise::normal;
  double alpha = 0.05;  // between 0 and 1
  int count = 100000;   // how many studies
  std::uint64_t seed = 1;
};

struct SimulatedPower {
  std::optional<double> power, se;       // nothing for no studies; se = sqrt(p (1 - p) / count)
  std::optional<std::int64_t> critical;  // see critical_rank_sum
};

SimulatedPower simulated_power(const SimulatedStudies& studies);

}  // namespace promenade::analysis
