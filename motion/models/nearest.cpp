#include "motion/models/nearest.h"

#include <cassert>
#include <cmath>
#include <limits>

namespace promenade::motion {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

// The value of rank k (from 0) among the entries, without moving or copying them.
double ranked(const VectorXd& values, int k) {
  double at = -1;
  for (Index passed = 0; passed <= k;) {
    double next = std::numeric_limits<double>::infinity();
    for (const double v : values) {
      if (v > at && v < next) next = v;
    }
    at = next;
    passed += (values.array() == at).count();
  }
  return at;
}

void normalise(VectorXd& weights) { weights /= weights.sum(); }

}  // namespace

void nearest_weights(const Eigen::MatrixXd& points, const Eigen::Ref<const VectorXd>& at, int k,
                     VectorXd& weights) {
  const Index n = points.cols();
  assert(k >= 1 && n >= 1 && "at least one example counts");
  weights.resize(n);
  for (Index i = 0; i < n; ++i) weights(i) = (points.col(i) - at).norm();
  const double least = weights.minCoeff();
  // Nearer than rounding: 1/d would only tell which of them was rounded best.
  if (const double exact = 1e-12 * weights.maxCoeff(); least <= exact) {
    for (double& w : weights) w = w <= exact ? 1 : 0;
    return normalise(weights);
  }
  const double edge = k < n ? ranked(weights, k) : std::numeric_limits<double>::infinity();
  if (edge <= least * (1 + 1e-12)) {
    for (double& w : weights) w = w <= edge ? 1 : 0;
    return normalise(weights);
  }
  for (double& w : weights) w = w < edge ? least / w - least / edge : 0;
  normalise(weights);
}

VectorXd nearest_weights(const Eigen::MatrixXd& points, const Eigen::Ref<const VectorXd>& at,
                         int k) {
  VectorXd weights;
  nearest_weights(points, at, k, weights);
  return weights;
}

int nearest_column(const Eigen::MatrixXd& points, const Eigen::Ref<const VectorXd>& at) {
  assert(points.cols() > 0 && "there are examples");
  int best = 0;
  double least = std::numeric_limits<double>::infinity();
  for (Index i = 0; i < points.cols(); ++i) {
    const double squared = (points.col(i) - at).squaredNorm();
    if (squared >= least) continue;
    least = squared;
    best = static_cast<int>(i);
  }
  return best;
}

}  // namespace promenade::motion
