#include "analysis/statistics/cronbach_alpha.h"

#include <limits>

#include "analysis/statistics/f_quantile.h"
#include "analysis/statistics/quiet.h"
#include "analysis/statistics/scaled_table.h"

namespace promenade::analysis {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

double variance_of(const VectorXd& values) {
  const VectorXd deviations = values.array() - values.mean();
  return deviations.squaredNorm() / static_cast<double>(values.size() - 1);
}

// What reading and adding k numbers up to 1 may change.
double rounding(Eigen::Index k) {
  return std::numeric_limits<double>::epsilon() * static_cast<double>(k * k);
}

bool is_constant(const VectorXd& values, double tolerance) {
  return values.maxCoeff() - values.minCoeff() <= tolerance;
}

std::optional<double> alpha_of(const VectorXd& totals, double variances, Eigen::Index items) {
  if (items < 2 || totals.size() < 2 || is_constant(totals, rounding(items))) return std::nullopt;
  const auto k = static_cast<double>(items);
  return if_finite(k / (k - 1) * (1 - variances / variance_of(totals)));
}

// The sum of all correlations is the squared length of the sum of the standardized items.
std::optional<double> standardized_alpha(MatrixXd x) {
  if (x.cols() < 2 || x.rows() < 2) return std::nullopt;
  for (auto item : x.colwise()) {
    if (is_constant(item, 0)) return std::nullopt;
    item.array() -= item.mean();
    item /= item.norm();
  }
  const auto k = static_cast<double>(x.cols());
  const double mean = (x.rowwise().sum().squaredNorm() - k) / (k * (k - 1));
  return ratio(k * mean, 1 + (k - 1) * mean);
}

// alpha without each item; variances are summed anew, for one may outweigh all others.
std::vector<std::optional<double>> without_each(const MatrixXd& x, const VectorXd& variances) {
  std::vector<std::optional<double>> result;
  if (x.cols() < 3) return result;
  for (Eigen::Index item = 0; item < x.cols(); ++item) {
    MatrixXd others = x;
    VectorXd rest = variances;
    others.col(item).setZero();
    rest(item) = 0;
    result.push_back(alpha_of(others.rowwise().sum(), rest.sum(), x.cols() - 1));
  }
  return result;
}

std::optional<Interval> feldt_interval(const CronbachAlpha& result, double level) {
  if (!result.alpha) return std::nullopt;
  const double error = 1 - *result.alpha;
  const double people = result.n - 1.0;
  const double rest = people * (result.k - 1.0);
  const double tail = (1 - level) / 2;
  return if_finite(Interval{1 - error * f_upper_quantile(tail, people, rest),
                            1 - error / f_upper_quantile(tail, rest, people)});
}

}  // namespace

CronbachAlpha cronbach_alpha(const std::vector<std::vector<double>>& answers, double level) {
  const MatrixXd x = scaled_table(answers).values;
  CronbachAlpha result;
  result.n = static_cast<int>(x.rows());
  result.k = static_cast<int>(x.cols());
  VectorXd variances = VectorXd::Zero(x.cols());
  for (Eigen::Index item = 0; result.n > 1 && item < x.cols(); ++item) {
    variances(item) = variance_of(x.col(item));
  }
  result.alpha = alpha_of(x.rowwise().sum(), variances.sum(), x.cols());
  result.interval = feldt_interval(result, level);
  result.standardized = standardized_alpha(x);
  result.if_dropped = without_each(x, variances);
  return result;
}

}  // namespace promenade::analysis
