#include "motion/models/map.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <vector>

#include "motion/models/nearest.h"
#include "motion/quantile.h"

namespace promenade::motion {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::Vector2d;
using Eigen::VectorXd;

int wanted_components(const Pca& pca, const MapOptions& options) {
  const int all = static_cast<int>(std::ceil(0.7 * (pca.size() - 1) - 1e-9));
  return std::min(std::max(options.components > 0 ? options.components : all, 2), pca.components());
}

// Along the line from `inside` to `outside`, both in standard deviations: the share
// (0 to 1) of the way that stays within `limit` of the origin.
template <typename Vector>
double share_within(const Vector& inside, const Vector& outside, double limit) {
  const double square = (outside - inside).squaredNorm();
  if (outside.norm() <= limit || square == 0) return 1;
  const double half = inside.dot(outside - inside);
  const double free = std::max(0.0, limit * limit - inside.squaredNorm());
  return std::clamp((std::sqrt(half * half + square * free) - half) / square, 0.0, 1.0);
}

Vector2d deviations_on_map(const Minimap& map) {
  Vector2d deviations = Vector2d::Ones();
  for (Index a = 0; a < std::min<Index>(2, map.deviations.size()); ++a) {
    deviations(a) = map.deviations(a) / map.unit(a);
  }
  return deviations;
}

double glide_left(const Minimap& map, const MapState& state, std::int64_t t_us) {
  if (map.options.glide_s <= 0) return 0;
  const auto passed = static_cast<double>(std::max<std::int64_t>(0, t_us - state.t_us)) * 1e-6;
  // Nobody sees the last thousandth, and what has arrived stands still.
  const double left = std::exp(-passed / map.options.glide_s);
  return left < 1e-3 ? 0 : left;
}

VectorXd drawn_rest(const Minimap& map, int nearest, const std::function<double()>& normal) {
  const auto deviations = map.deviations.tail(map.rest.rows()).array();
  VectorXd drawn(map.rest.rows());
  for (double& value : drawn) value = normal();
  const VectorXd example = map.rest.col(nearest).array() / deviations;
  const double share = share_within(example, drawn, map.rest_limit);
  return (example + share * (drawn - example)).array() * deviations;
}

}  // namespace

double leave_one_out_limit(const MatrixXd& components, double confidence) {
  const auto n = static_cast<double>(components.cols());
  if (components.rows() == 0) return 0;
  const VectorXd inverse = components.rowwise().squaredNorm().cwiseInverse();
  double own = 0;
  std::vector<double> left_out;
  for (Index i = 0; i < components.cols(); ++i) {
    // Sherman-Morrison on the scatter without example i, whose mean moves too.
    const double leverage = components.col(i).cwiseAbs2().dot(inverse);
    const double rest = std::max(1e-12, 1 - leverage * n / (n - 1));
    left_out.push_back(std::sqrt((n - 2) * leverage / rest) * n / (n - 1));
    own = std::max(own, std::sqrt((n - 1) * leverage));
  }
  return std::max(own, quantile(std::move(left_out), confidence));
}

Minimap make_minimap(const Pca& pca, const MapOptions& options) {
  assert(pca.components() >= 1 && "examples that differ");
  Minimap map;
  map.options = options;
  const Index k = wanted_components(pca, options);
  const Index plane = std::min<Index>(2, k);
  map.deviations = pca.variances.head(k).cwiseSqrt();
  map.explained = pca.variances.head(k) / pca.total_variance;
  map.unit.setOnes();
  if (options.metric == MapMetric::mahalanobis) map.unit.head(plane) = map.deviations.head(plane);
  map.examples = Eigen::Matrix2Xd::Zero(2, pca.size());
  map.examples.topRows(plane) =
      map.unit.head(plane).cwiseInverse().asDiagonal() * pca.coordinates.topRows(plane);
  map.rest = pca.coordinates.middleRows(plane, k - plane);
  map.to_weights = (pca.variances.head(k) * (pca.size() - 1)).cwiseInverse().asDiagonal() *
                   pca.coordinates.topRows(k);
  map.to_weights.transposeInPlace();
  const Vector2d deviations = deviations_on_map(map);
  const double farthest =
      (deviations.cwiseInverse().asDiagonal() * map.examples).colwise().norm().maxCoeff();
  // The quantile of chi-square with two degrees of freedom is -2 log(1 - c).
  map.point_limit = std::max(farthest, std::sqrt(-2 * std::log(1 - options.confidence)));
  map.rest_limit = leave_one_out_limit(map.rest, options.confidence);
  return map;
}

MapState start_map(const Minimap& map) {
  MapState state;
  state.rest = state.goal = VectorXd::Zero(map.rest.rows());
  return state;
}

Vector2d valid_radii(const Minimap& map) { return map.point_limit * deviations_on_map(map); }

Vector2d pull_back(const Minimap& map, const Vector2d& point) {
  const Vector2d deviations = deviations_on_map(map);
  const Vector2d inside = map.examples.col(nearest_column(map.examples, point));
  const double share = share_within<Vector2d>(inside.cwiseQuotient(deviations),
                                              point.cwiseQuotient(deviations), map.point_limit);
  return share < 1 ? Vector2d(inside + share * (point - inside)) : point;
}

MapState move(const Minimap& map, MapState state, const MapMove& event,
              const std::function<double()>& normal) {
  // A blend of examples is valid wherever the cursor is.
  const MapHeuristic heuristic = map.options.heuristic;
  const Vector2d point =
      heuristic == MapHeuristic::weights ? event.point : pull_back(map, event.point);
  const int nearest = nearest_column(map.examples, point);
  if (heuristic == MapHeuristic::closest) {
    state.rest = rest_at(map, state, event.t_us);
    state.goal = map.rest.col(nearest);
  } else if (heuristic == MapHeuristic::random && event.pick) {
    state.rest = state.goal = drawn_rest(map, nearest, normal);
  }
  state.point = point;
  state.t_us = event.t_us;
  return state;
}

VectorXd rest_at(const Minimap& map, const MapState& state, std::int64_t t_us) {
  return state.goal + glide_left(map, state, t_us) * (state.rest - state.goal);
}

void weights_at(const Minimap& map, const MapState& state, std::int64_t t_us, VectorXd& weights) {
  if (map.options.heuristic == MapHeuristic::weights) {
    return nearest_weights(map.examples, state.point, map.options.nearest, weights);
  }
  weights.setConstant(map.size(), 1.0 / map.size());
  const Index plane = map.components() - map.rest.rows();
  for (Index k = 0; k < plane; ++k) {
    weights += map.to_weights.col(k) * (state.point(k) * map.unit(k));
  }
  const double left = glide_left(map, state, t_us);
  for (Index k = 0; k < map.rest.rows(); ++k) {
    weights +=
        map.to_weights.col(plane + k) * (state.goal(k) + left * (state.rest(k) - state.goal(k)));
  }
}

}  // namespace promenade::motion
