#include "analysis/statistics/mcnemar.h"

#include <algorithm>
#include <cmath>

#include "analysis/statistics/sign_test.h"

namespace promenade::analysis {
namespace {

double one_degree_tail(double chi2) { return std::erfc(std::sqrt(chi2 / 2)); }

}  // namespace

McNemarTest mcnemar(int first_only, int second_only) {
  const SignTest sign = sign_test(first_only, second_only);
  McNemarTest test;
  test.p_exact = sign.two;
  if (sign.n == 0) return test;
  // Half of the point on either side; with equal counts it is the same point twice.
  const double point = sign_test_point(first_only, second_only);
  test.p_mid = first_only == second_only ? 1 - point : sign.two - point;
  const double apart = std::abs(static_cast<double>(first_only) - second_only);
  const double corrected = std::max(apart - 1, 0.0);
  test.chi2 = apart * apart / sign.n;
  test.chi2_corrected = corrected * corrected / sign.n;
  test.p_chi2 = one_degree_tail(*test.chi2);
  test.p_chi2_corrected = one_degree_tail(*test.chi2_corrected);
  return test;
}

}  // namespace promenade::analysis
