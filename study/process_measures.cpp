#include "study/process_measures.h"

#include <algorithm>
#include <cmath>

#include "motion/models/pca.h"

namespace promenade::study {
namespace {

constexpr int cells = 10;                         // along each side of the map
constexpr double margin = 0.1;                    // around the examples, of their extent
constexpr std::int64_t rest_us = 2'000'000;       // from here on it counts as idle
constexpr std::int64_t camera_rest_us = 500'000;  // between two gestures of the camera
constexpr double as_it_is = 1e-6;                 // how near a weight is to 1

double seconds(std::int64_t us) { return 1e-6 * static_cast<double>(us); }

}  // namespace

int CoverageMap::cell_of(const Eigen::VectorXd& weights) const {
  const Eigen::RowVector2d point = weights.transpose() * examples;
  int index = 0;
  for (int axis = 0; axis < 2; ++axis) {
    const double at = cell(axis) > 0 ? std::floor((point(axis) - least(axis)) / cell(axis)) : 0;
    if (!(at >= 0 && at < cells)) return -1;
    index = index * cells + static_cast<int>(at);
  }
  return index;
}

CoverageMap make_coverage_map(const motion::MotionSpace& space) {
  CoverageMap map;
  map.examples = Eigen::MatrixX2d::Zero(space.set.size(), 2);
  const motion::Pca pca = motion::principal_components(space);
  const int known = std::min(2, pca.components());
  map.examples.leftCols(known) = pca.coordinates.topRows(known).transpose();
  const Eigen::RowVector2d low = map.examples.colwise().minCoeff();
  const Eigen::RowVector2d extent = map.examples.colwise().maxCoeff() - low;
  map.least = low - margin * extent;
  map.cell = (1 + 2 * margin) / cells * extent;
  return map;
}

void ProcessMeter::begin(std::int64_t t_us) {
  measures_ = {};
  shown_us_ = input_us_ = t_us;
  camera_us_ = -1;
  d_.reset();
  weights_.resize(0);
}

void ProcessMeter::shown(std::int64_t t_us, std::optional<double> d, double way_m,
                         const Eigen::VectorXd& weights, const CoverageMap& map, bool changed) {
  if (d_) {
    measures_.d_area_m_s = measures_.d_area_m_s.value_or(0) + *d_ * seconds(t_us - shown_us_);
  }
  shown_us_ = t_us;
  d_ = d;
  measures_.path_m += way_m;
  visit(weights, map);
  if (weights_.size() != weights.size()) {
    weights_ = turned_ = weights;
    direction_ = Eigen::VectorXd::Zero(weights.size());
    return;
  }
  // The way of a gesture is known when the next one begins.
  if (changed) {
    turn();
    turned_ = weights_;
  }
  weights_ = weights;
}

void ProcessMeter::turn() {
  const Eigen::VectorXd way = weights_ - turned_;
  if (way.squaredNorm() == 0) return;
  measures_.reversals += direction_.dot(way) < 0 ? 1 : 0;
  direction_ = way;
}

void ProcessMeter::visit(const Eigen::VectorXd& weights, const CoverageMap& map) {
  if (examples_.size() != static_cast<std::size_t>(weights.size())) {
    examples_.assign(static_cast<std::size_t>(weights.size()), false);
    cells_.reset();
  }
  const int cell = map.cell_of(weights);
  if (cell >= 0) cells_.set(static_cast<std::size_t>(cell));
  Eigen::Index most = 0;
  if (weights.maxCoeff(&most) >= 1 - as_it_is) examples_[static_cast<std::size_t>(most)] = true;
}

void ProcessMeter::input(std::int64_t t_us) {
  const std::int64_t rest = t_us - input_us_;
  if (rest > rest_us) measures_.idle_us += rest;
  input_us_ = t_us;
}

void ProcessMeter::camera(std::int64_t t_us) {
  if (camera_us_ < 0 || t_us - camera_us_ > camera_rest_us) ++measures_.camera_moves;
  camera_us_ = t_us;
}

ProcessMeasures ProcessMeter::at(std::int64_t t_us) const {
  ProcessMeter end = *this;
  end.input(t_us);
  end.turn();
  ProcessMeasures& measures = end.measures_;
  if (d_) measures.d_area_m_s = measures.d_area_m_s.value_or(0) + *d_ * seconds(t_us - shown_us_);
  measures.examples_visited =
      static_cast<int>(std::count(examples_.begin(), examples_.end(), true));
  measures.map_coverage = static_cast<double>(cells_.count()) / (cells * cells);
  return measures;
}

}  // namespace promenade::study
