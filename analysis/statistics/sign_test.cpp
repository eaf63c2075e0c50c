#include "analysis/statistics/sign_test.h"

#include <algorithm>
#include <boost/math/distributions/binomial.hpp>
#include <cassert>

namespace promenade::analysis {
namespace {

using Heads = boost::math::binomial_distribution<double>;

// P(X <= k) for n coins.
double lower_tail(int k, int n) { return n == 0 ? 1.0 : boost::math::cdf(Heads(n, 0.5), k); }

}  // namespace

SignTest sign_test(int positive, int negative) {
  assert(positive >= 0 && negative >= 0 && "counts are never negative");
  SignTest test;
  test.n = positive + negative;
  test.less = lower_tail(positive, test.n);
  test.greater = lower_tail(negative, test.n);
  test.two = std::min(1.0, 2 * std::min(test.less, test.greater));
  return test;
}

double sign_test_point(int positive, int negative) {
  const int n = positive + negative;
  return n == 0 ? 1.0 : boost::math::pdf(Heads(n, 0.5), positive);
}

}  // namespace promenade::analysis
