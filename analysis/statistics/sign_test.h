// The sign test: of n differences that are not zero each is positive with
// probability 1/2. Exact, by the binomial distribution.
#pragma once

namespace promenade::analysis {

struct SignTest {
  int n = 0;  // positive and negative
  double two = 1, greater = 1, less = 1;
};

// greater = P(X >= positive), less = P(X <= positive), X ~ Bin(n, 1/2); `two` doubles the
// smaller one, at most 1. All are 1 for n = 0.
SignTest sign_test(int positive, int negative);

// P(X = positive).
double sign_test_point(int positive, int negative);

}  // namespace promenade::analysis
