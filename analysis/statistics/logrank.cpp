#include "analysis/statistics/logrank.h"

#include <Eigen/Dense>
#include <algorithm>
#include <boost/math/special_functions/gamma.hpp>
#include <cassert>
#include <numeric>

namespace promenade::analysis {
namespace {

using Counts = std::vector<int>;  // by group

void add_time(LogRankTest& test, const Counts& at_risk, const Counts& done) {
  const double n = std::accumulate(at_risk.begin(), at_risk.end(), 0);
  const double d = std::accumulate(done.begin(), done.end(), 0);
  if (d == 0) return;
  const double spread = n > 1 ? d * (n - d) / (n - 1) : 0;
  for (std::size_t i = 0; i < at_risk.size(); ++i) {
    const double part = at_risk[i] / n;
    test.observed[i] += done[i];
    test.expected[i] += d * part;
    test.variance[i][i] += spread * part;
    for (std::size_t j = 0; j < at_risk.size(); ++j) {
      test.variance[i][j] -= spread * part * at_risk[j] / n;
    }
  }
}

using Place = std::vector<GroupedDuration>::const_iterator;

// One stratum, by time.
void add_stratum(LogRankTest& test, Place begin, Place end) {
  const std::size_t groups = test.observed.size();
  Counts at_risk(groups, 0);
  for (Place one = begin; one != end; ++one) ++at_risk[static_cast<std::size_t>(one->group)];
  while (begin != end) {
    Counts done(groups, 0);
    Counts left(groups, 0);
    for (const double now = begin->duration.time; begin != end && begin->duration.time == now;
         ++begin) {
      const auto group = static_cast<std::size_t>(begin->group);
      done[group] += begin->duration.done ? 1 : 0;
      ++left[group];
    }
    add_time(test, at_risk, done);
    for (std::size_t i = 0; i < groups; ++i) at_risk[i] -= left[i];
  }
}

std::optional<double> statistic(const LogRankTest& test) {
  if (test.df < 1) return std::nullopt;
  Eigen::MatrixXd variance(test.df, test.df);
  Eigen::VectorXd surplus(test.df);
  for (int i = 0; i < test.df; ++i) {
    const auto row = static_cast<std::size_t>(i);
    surplus(i) = test.observed[row] - test.expected[row];
    for (int j = 0; j < test.df; ++j) {
      variance(i, j) = test.variance[row][static_cast<std::size_t>(j)];
    }
  }
  Eigen::FullPivLU<Eigen::MatrixXd> inverse(variance);
  inverse.setThreshold(1e-12);  // what rounding leaves of a variance of zero is smaller
  if (!inverse.isInvertible()) return std::nullopt;
  return std::max(0.0, surplus.dot(inverse.solve(surplus)));
}

}  // namespace

LogRankTest logrank(std::vector<GroupedDuration> durations, int groups) {
  std::sort(
      durations.begin(), durations.end(), [](const GroupedDuration& a, const GroupedDuration& b) {
        return a.stratum != b.stratum ? a.stratum < b.stratum : a.duration.time < b.duration.time;
      });
  LogRankTest test;
  const auto size = static_cast<std::size_t>(groups);
  test.observed.assign(size, 0.0);
  test.expected.assign(size, 0.0);
  test.variance.assign(size, std::vector<double>(size, 0.0));
  test.df = std::max(groups - 1, 0);
  for (auto begin = durations.cbegin(); begin != durations.cend();) {
    assert(begin->group >= 0 && begin->group < groups && "the group is one of those");
    const auto end = std::find_if(begin, durations.cend(), [&](const GroupedDuration& one) {
      return one.stratum != begin->stratum;
    });
    add_stratum(test, begin, end);
    begin = end;
  }
  test.chi2 = statistic(test);
  if (test.chi2) test.p = boost::math::gamma_q(test.df / 2.0, *test.chi2 / 2);
  return test;
}

}  // namespace promenade::analysis
