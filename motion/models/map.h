// The minimap ([N] 5.4-5.5; docs/methods.md, 7): a point of the plane is a motion. The first
// two principal components are the cursor; a heuristic says what the others are. Here
// is the model only: a state that changes with events and weights that are a function
// of those events and the time, never of frames, so that a replay meets them again.
#pragma once

#include <cstdint>
#include <functional>

#include "motion/models/pca.h"

namespace promenade::motion {

enum class MapHeuristic {
  zero,     // the other components are 0
  closest,  // they glide towards those of the example nearest to the cursor
  weights,  // the k nearest examples are blended; no components are needed
  random    // they are drawn from N(0, lambda_k) at every pick
};

// Mahalanobis: each axis in standard deviations of the examples (ours; [N] "could also
// be used").
enum class MapMetric { euclidean, mahalanobis };

struct MapOptions {
  MapHeuristic heuristic = MapHeuristic::closest;
  MapMetric metric = MapMetric::euclidean;
  int components = 0;        // K, 2 to R; 0: ceil(0.7 (N-1)), [N]'s 38 of 55 walks
  int nearest = 5;           // k of `weights`; N: the plain formula
  double glide_s = 0.15;     // time constant of `closest`, seconds; 0: at once
  double confidence = 0.95;  // of the bounds of validity
};

struct Minimap {
  MapOptions options;
  Eigen::Matrix2Xd examples;   // 2 x N, where the dots are, in the unit of the metric
  Eigen::Vector2d unit;        // PCA coordinate of 1 on either axis
  Eigen::MatrixXd rest;        // (K-2) x N: components 3 to K of the examples
  Eigen::VectorXd deviations;  // K: sqrt(lambda_k)
  Eigen::MatrixXd to_weights;  // N x K: U L^(-1/2)
  Eigen::VectorXd explained;   // K: share of the variance of each component
  double point_limit = 0;      // largest valid Mahalanobis distance on the plane
  double rest_limit = 0;       // the same of components 3 to K

  int size() const { return static_cast<int>(examples.cols()); }
  int components() const { return static_cast<int>(deviations.size()); }
};

// Of a PCA with at least one component; a second axis is 0 if there is none.
Minimap make_minimap(const Pca& pca, const MapOptions& options = {});

// The Mahalanobis bound that the method sets for components 3 to K: the quantile of the
// examples' distances, each measured by mean and covariance of the others; never
// less than an example's own distance. `components` is k x N, uncorrelated.
double leave_one_out_limit(const Eigen::MatrixXd& components, double confidence);

struct MapState {
  Eigen::Vector2d point = Eigen::Vector2d::Zero();  // the cursor, pulled back if need be
  Eigen::VectorXd rest;                             // K-2: the other components at t_us
  Eigen::VectorXd goal;                             // K-2: where they go
  std::int64_t t_us = 0;                            // of the last event
};

// The average motion, at the origin.
MapState start_map(const Minimap& map);

struct MapMove {
  Eigen::Vector2d point = Eigen::Vector2d::Zero();  // in the unit of the map
  bool pick = true;                                 // false: dragged on from the last one
  std::int64_t t_us = 0;
};

// A new cursor. `normal` draws standard normal numbers (heuristic `random` only).
MapState move(const Minimap& map, MapState state, const MapMove& event,
              const std::function<double()>& normal);

// Components 3 to K at a time.
Eigen::VectorXd rest_at(const Minimap& map, const MapState& state, std::int64_t t_us);

// N weights, sum 1; negative ones occur but with `weights`. Allocation-free when
// `weights` has N.
void weights_at(const Minimap& map, const MapState& state, std::int64_t t_us,
                Eigen::VectorXd& weights);

// Half axes of the ellipse around the origin whose points are valid, in the unit of the
// map. With the heuristic `weights` every point is.
Eigen::Vector2d valid_radii(const Minimap& map);

// The nearest valid point on the way to the nearest example; unchanged when valid.
Eigen::Vector2d pull_back(const Minimap& map, const Eigen::Vector2d& point);

}  // namespace promenade::motion
