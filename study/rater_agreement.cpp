#include "study/rater_agreement.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

#include "study/rng.h"

namespace promenade::study {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using motion::PairFate;

// What one rater said about one motion, on all pairs.
struct Units {
  std::vector<int> rater, motion;       // U, by rater
  MatrixXd value, known;                // P x U: ratings; 1 where there is one, else 0
  MatrixXd centred;                     // P x U: without the rater's mean of the pair; 0: no rating
  VectorXd variation;                   // P: sum of the squares of `centred`
  std::vector<std::size_t> block_ends;  // units between two ends are shuffled

  std::size_t size() const { return rater.size(); }
};

Units collect(const RatingsTable& table) {
  std::map<std::pair<int, int>, Index> columns;
  for (const motion::Rating& one : table.ratings) columns[{one.rater, one.motion}] = 0;
  Units units;
  for (auto& [key, column] : columns) {
    column = static_cast<Index>(units.size());
    units.rater.push_back(key.first);
    units.motion.push_back(key.second);
  }
  const auto pairs = static_cast<Index>(table.pairs.size());
  units.value = MatrixXd::Zero(pairs, static_cast<Index>(units.size()));
  units.known = units.value;
  for (const motion::Rating& one : table.ratings) {
    const Index column = columns.at({one.rater, one.motion});
    units.value(one.pair, column) += one.value;
    units.known(one.pair, column) += 1;
  }
  // Several ratings of one person, pair and motion count as one, their mean.
  units.value.array() /= units.known.array().max(1);
  units.known = units.known.cwiseMin(1);
  return units;
}

// Units of one rater follow each other.
void find_blocks(Units& units) {
  bool several = false;
  for (std::size_t u = 1; u <= units.size(); ++u) {
    const bool ends = u == units.size() || units.rater[u] != units.rater[u - 1];
    if (ends) units.block_ends.push_back(u);
    several = several || !ends;
  }
  if (!several) units.block_ends = {units.size()};
}

void centre(Units& units) {
  units.centred = units.value;
  std::size_t begin = 0;
  for (const std::size_t end : units.block_ends) {
    const auto first = static_cast<Index>(begin);
    const auto count = static_cast<Index>(end - begin);
    const VectorXd given = units.known.middleCols(first, count).rowwise().sum().cwiseMax(1);
    const VectorXd mean = units.value.middleCols(first, count).rowwise().sum().cwiseQuotient(given);
    units.centred.middleCols(first, count) -=
        mean.asDiagonal() * units.known.middleCols(first, count);
    begin = end;
  }
  units.variation = units.centred.rowwise().squaredNorm();
}

struct Sums {
  MatrixXd count, sum, squares, centred;  // P x N
};

Sums sums_of(const Units& units, const std::vector<int>& motion, int motions) {
  const MatrixXd zero = MatrixXd::Zero(units.value.rows(), motions);
  Sums sums{zero, zero, zero, zero};
  for (std::size_t u = 0; u < units.size(); ++u) {
    const auto column = static_cast<Index>(u);
    const auto value = units.value.col(column);
    sums.count.col(motion[u]) += units.known.col(column);
    sums.sum.col(motion[u]) += value;
    sums.squares.col(motion[u]) += value.cwiseAbs2();
    sums.centred.col(motion[u]) += units.centred.col(column);
  }
  return sums;
}

// mu* and sigma as motion::quantify has them.
PairFate fate_of(const Sums& sums, Index pair, const motion::QuantificationOptions& options) {
  double extreme = 0;
  double deviations = 0;
  int known = 0;
  for (Index i = 0; i < sums.count.cols(); ++i) {
    const double count = sums.count(pair, i);
    if (count == 0) return PairFate::unrated;
    const double mean = sums.sum(pair, i) / count;
    extreme = std::max(extreme, std::abs(mean));
    if (count < 2) continue;
    const double left = std::max(0.0, sums.squares(pair, i) - count * mean * mean);
    deviations += std::sqrt(left / (count - 1));
    ++known;
  }
  return known == 0 ? PairFate::unrated : motion::fate_of(extreme, deviations / known, options);
}

// The share of a pair's variance within raters that the motions explain.
double share_explained(const Units& units, const Sums& sums, Index pair) {
  if (units.variation(pair) <= 0) return 0;
  double between = 0;
  for (Index i = 0; i < sums.count.cols(); ++i) {
    if (sums.count(pair, i) == 0) continue;
    between += sums.centred(pair, i) * sums.centred(pair, i) / sums.count(pair, i);
  }
  return between / units.variation(pair);
}

// Summed over the pairs that are left.
double explained_sum(const Units& units, const std::vector<int>& motion, int motions,
                     const motion::QuantificationOptions& options) {
  const Sums sums = sums_of(units, motion, motions);
  double sum = 0;
  for (Index pair = 0; pair < units.value.rows(); ++pair) {
    if (fate_of(sums, pair, options) == PairFate::kept) sum += share_explained(units, sums, pair);
  }
  return sum;
}

// Within each block.
std::vector<int> shuffled(const Units& units, Rng& rng) {
  std::vector<int> motion;
  motion.reserve(units.size());
  std::vector<int> block;
  std::size_t begin = 0;
  for (const std::size_t end : units.block_ends) {
    block.assign(units.motion.begin() + static_cast<std::ptrdiff_t>(begin),
                 units.motion.begin() + static_cast<std::ptrdiff_t>(end));
    rng.shuffle(block);
    motion.insert(motion.end(), block.begin(), block.end());
    begin = end;
  }
  return motion;
}

void test_by_shuffling(const RatingsTable& table, const motion::QuantificationOptions& options,
                       RaterAgreement& result) {
  Units units = collect(table);
  find_blocks(units);
  centre(units);
  const int motions = static_cast<int>(table.motions.size());
  const double seen = explained_sum(units, units.motion, motions, options);
  result.explained = seen / result.kept;
  int as_good = 1;  // what was seen is one of the orders
  for (int i = 0; i < RaterAgreement::shuffles; ++i) {
    Rng rng(1, static_cast<std::uint64_t>(i), "agreement");
    // Sums in another order differ in their last bits.
    const double other = explained_sum(units, shuffled(units, rng), motions, options);
    if (other >= seen * (1 - 1e-9)) ++as_good;
  }
  result.p = as_good / (RaterAgreement::shuffles + 1.0);
}

}  // namespace

RaterAgreement rater_agreement(const RatingsTable& table, const motion::Quantification& q,
                               const motion::QuantificationOptions& options) {
  const auto count = [&](PairFate fate) {
    return static_cast<int>(std::count(q.fate.begin(), q.fate.end(), fate));
  };
  RaterAgreement result;
  result.asked = static_cast<int>(table.pairs.size());
  result.kept = count(PairFate::kept);
  result.never_extreme = count(PairFate::never_extreme);
  result.disagreed = count(PairFate::disagreed);
  result.unrated = count(PairFate::unrated);
  result.wanted = std::min(options.clusters, result.asked);
  if (result.kept > 0) test_by_shuffling(table, options, result);
  return result;
}

std::string describe(const RaterAgreement& found) {
  const std::string left = fmt::format(
      "{} of {} pairs {} left ({} never far from neutral, {} on which raters differ too much, {} "
      "not rated everywhere), and {} {} needed",
      found.kept, found.asked, found.kept == 1 ? "is" : "are", found.never_extreme, found.disagreed,
      found.unrated, found.wanted, found.wanted == 1 ? "is" : "are");
  const std::string chance =
      fmt::format("the motions explain {:.0f} % of the variance within raters, p = {} by chance",
                  100 * found.explained, found.p);
  if (found.agrees()) return fmt::format("the ratings agree: {}; {}", left, chance);
  constexpr const char* advice =
      "ask more people, look for a rater who is unlike the others, or ask other pairs";
  if (!found.enough()) return fmt::format("the ratings do not agree: {}; {}", left, advice);
  return fmt::format("the ratings do not agree: {}, but {}, more than {}; {}", left, chance,
                     RaterAgreement::level, advice);
}

}  // namespace promenade::study
