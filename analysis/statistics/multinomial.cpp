#include "analysis/statistics/multinomial.h"

#include <algorithm>
#include <boost/math/special_functions/gamma.hpp>
#include <cassert>
#include <cmath>
#include <numeric>

namespace promenade::analysis {
namespace {

double log_factorial(int n) { return std::lgamma(n + 1.0); }

// Walks through the partitions of n into at most k parts, the largest first. Each stands for
// k! / (its multiplicities)! orders.
class Partitions {
 public:
  Partitions(int n, int k, double seen)
      : seen_(seen), scale_(log_factorial(n) - n * std::log(k) + log_factorial(k)) {
    share(n, k, n, 0, 0, 0);
  }
  double tail() const { return tail_; }

 private:
  // log_parts: sum of log c! of the parts so far; log_same: of log (multiplicity)!; run: how
  // often the last part, `most`, stands there.
  void share(int rest, int places, int most, int run, double log_parts, double log_same) {
    if (places == 0) return add(log_parts, log_same + log_factorial(run));
    const int least = (rest + places - 1) / places;
    for (int part = std::min(rest, most); part >= least; --part) {
      const bool again = part == most && run > 0;
      share(rest - part, places - 1, part, again ? run + 1 : 1, log_parts + log_factorial(part),
            again ? log_same : log_same + log_factorial(run));
    }
  }

  void add(double log_parts, double log_same) {
    if (log_parts >= seen_ - 1e-7) tail_ += std::exp(scale_ - log_parts - log_same);
  }

  double seen_, scale_;
  double tail_ = 0;
};

// About how many partitions there are: the orders, divided by k!.
double partitions_of(int n, int k) {
  return std::exp(log_factorial(n + k - 1) - log_factorial(n) - log_factorial(k - 1) -
                  log_factorial(k));
}

}  // namespace

EqualChoices equal_choices(const std::vector<int>& counts) {
  assert(counts.size() > 1 && "one choice is none");
  const int n = std::accumulate(counts.begin(), counts.end(), 0);
  const int k = static_cast<int>(counts.size());
  EqualChoices test;
  double seen = 0;
  for (const int count : counts) {
    const double expected = static_cast<double>(n) / k;
    test.chi2 += (count - expected) * (count - expected) / expected;
    seen += log_factorial(count);
  }
  test.p_chi2 = boost::math::gamma_q((k - 1) / 2.0, test.chi2 / 2);
  if (partitions_of(n, k) <= multinomial_limit) {
    test.p_exact = std::min(1.0, Partitions(n, k, seen).tail());
  }
  return test;
}

}  // namespace promenade::analysis
