#include "analysis/statistics/power_simulated.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <vector>

#include "analysis/statistics/power_sign_flips.h"
#include "study/rng.h"

namespace promenade::analysis {
namespace {

double t3(study::Rng& rng) {
  const double z = rng.normal();
  double squares = 0;
  for (int i = 0; i < 3; ++i) {
    const double other = rng.normal();
    squares += other * other;
  }
  return z / std::sqrt(squares);  // t is sqrt(3) times this
}

double laplace(study::Rng& rng) {
  const double magnitude = -std::log(1 - rng.uniform()) / std::sqrt(2.0);
  return rng.next() % 2 == 0 ? magnitude : -magnitude;
}

double draw(Noise noise, study::Rng& rng) {
  switch (noise) {
    case Noise::t3:
      return t3(rng);
    case Noise::laplace:
      return laplace(rng);
    case Noise::normal:
      break;
  }
  return rng.normal();
}

// Magnitudes of doubles are ordered as their bits are; the sign goes to the end, and sorting
// whole numbers ranks the magnitudes.
std::uint64_t magnitude_and_sign(double value) {
  return std::rotl(std::bit_cast<std::uint64_t>(value), 1);
}

std::int64_t smaller_rank_sum(std::vector<std::uint64_t>& differences) {
  std::sort(differences.begin(), differences.end());
  std::int64_t minus = 0;
  for (std::size_t i = 0; i < differences.size(); ++i) {
    minus += (differences[i] & 1) != 0 ? static_cast<std::int64_t>(i) + 1 : 0;
  }
  const auto n = static_cast<std::int64_t>(differences.size());
  return std::min(minus, n * (n + 1) / 2 - minus);
}

}  // namespace

SimulatedPower simulated_power(const SimulatedStudies& studies) {
  SimulatedPower result;
  result.critical = critical_rank_sum(studies.n, studies.alpha);
  if (studies.count < 1) return result;
  study::Rng rng(studies.seed, 0, "power");
  std::vector<std::uint64_t> differences(static_cast<std::size_t>(studies.n));
  int rejected = 0;
  for (int i = 0; i < studies.count; ++i) {
    for (std::uint64_t& one : differences) {
      one = magnitude_and_sign(studies.shift + draw(studies.noise, rng));
    }
    rejected += result.critical && smaller_rank_sum(differences) <= *result.critical ? 1 : 0;
  }
  result.power = static_cast<double>(rejected) / studies.count;
  result.se = std::sqrt(*result.power * (1 - *result.power) / studies.count);
  return result;
}

}  // namespace promenade::analysis
