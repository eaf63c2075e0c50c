#include "analysis/statistics/icc.h"

#include <boost/math/distributions/fisher_f.hpp>
#include <cmath>
#include <limits>

#include "analysis/statistics/f_quantile.h"
#include "analysis/statistics/quiet.h"
#include "analysis/statistics/scaled_table.h"

namespace promenade::analysis {
namespace {

using Eigen::MatrixXd;

struct MeanSquares {
  double rows = 0, cols = 0, error = 0, within = 0;
};

// Squares of deviations, or zero where rounding made them.
double sum_of_squares(const MatrixXd& deviations, double rounding) {
  return deviations.cwiseAbs().maxCoeff() <= rounding ? 0.0 : deviations.squaredNorm();
}

// Of a table of numbers up to 1. Infinite or NaN where there are no degrees of freedom.
MeanSquares mean_squares(const MatrixXd& x) {
  const auto n = static_cast<double>(x.rows());
  const auto k = static_cast<double>(x.cols());
  const double rounding = std::numeric_limits<double>::epsilon() * (n + k);
  const MatrixXd centred = x.array() - x.mean();
  const Eigen::VectorXd rows = centred.rowwise().mean();
  const Eigen::RowVectorXd cols = centred.colwise().mean();
  const MatrixXd within = centred.colwise() - rows;
  const MatrixXd error = within.rowwise() - cols;
  return {k * sum_of_squares(rows, rounding) / (n - 1),
          n * sum_of_squares(cols, rounding) / (k - 1),
          sum_of_squares(error, rounding) / ((n - 1) * (k - 1)),
          sum_of_squares(within, rounding) / (n * (k - 1))};
}

void put_mean_squares(Icc& result, const MeanSquares& ms, int exponent) {
  const auto unscaled = [&](double value) { return if_finite(std::ldexp(value, 2 * exponent)); };
  result.ms_rows = unscaled(ms.rows);
  result.ms_cols = unscaled(ms.cols);
  result.ms_error = unscaled(ms.error);
  result.ms_within = unscaled(ms.within);
}

void put_correlations(Icc& result, const MeanSquares& ms) {
  const double n = result.n;
  const double k = result.k;
  const double between = ms.rows - ms.error;
  result.one_way = ratio(ms.rows - ms.within, ms.rows + (k - 1) * ms.within);
  result.one_way_mean = ratio(ms.rows - ms.within, ms.rows);
  result.agreement = ratio(between, ms.rows + (k - 1) * ms.error + k * (ms.cols - ms.error) / n);
  result.agreement_mean = ratio(between, ms.rows + (ms.cols - ms.error) / n);
  result.consistency = ratio(between, ms.rows + (k - 1) * ms.error);
  result.consistency_mean = ratio(between, ms.rows);
}

void put_test(Icc& result, const MeanSquares& ms) {
  result.f_rows = ratio(ms.rows, ms.error);
  if (!result.f_rows) return;
  const double n = result.n;
  const boost::math::fisher_f_distribution<double, Quiet> f(n - 1, (n - 1) * (result.k - 1.0));
  result.p_rows = if_finite(cdf(complement(f, *result.f_rows)));
}

// Satterthwaite's degrees of freedom of the denominator of the agreement.
double degrees_of_freedom(const Icc& result, const MeanSquares& ms) {
  const double n = result.n;
  const double k = result.k;
  const double r = *result.agreement;
  const double raters = k * r * ms.cols;
  const double rest = (n * (1 + (k - 1) * r) - k * r) * ms.error;
  return (k - 1) * (n - 1) * (raters + rest) * (raters + rest) /
         ((n - 1) * raters * raters + rest * rest);
}

void put_intervals(Icc& result, const MeanSquares& ms) {
  if (!result.agreement) return;
  const double n = result.n;
  const double k = result.k;
  const double df = degrees_of_freedom(result, ms);
  if (!std::isfinite(df) || df <= 0) return;
  const double below = f_upper_quantile(0.025, n - 1, df);
  const double above = f_upper_quantile(0.025, df, n - 1);
  const double rest = k * ms.cols + (k * n - k - n) * ms.error;
  const double lower = n * (ms.rows - below * ms.error) / (below * rest + n * ms.rows);
  const double upper = n * (above * ms.rows - ms.error) / (rest + n * above * ms.rows);
  const auto of_mean = [&](double r) { return k * r / (1 + (k - 1) * r); };
  result.interval = if_finite(Interval{lower, upper});
  result.interval_mean = if_finite(Interval{of_mean(lower), of_mean(upper)});
}

}  // namespace

Icc icc(const std::vector<std::vector<double>>& x) {
  const ScaledTable table = scaled_table(x);
  Icc result;
  result.n = static_cast<int>(x.size());
  result.k = static_cast<int>(x[0].size());
  const MeanSquares ms = mean_squares(table.values);
  put_mean_squares(result, ms, table.exponent);
  if (result.n < 2 || result.k < 2) return result;
  put_correlations(result, ms);
  put_test(result, ms);
  put_intervals(result, ms);
  return result;
}

}  // namespace promenade::analysis
