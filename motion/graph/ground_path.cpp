#include "motion/graph/ground_path.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "motion/problem.h"

namespace promenade::motion {
namespace {

using Eigen::Matrix2Xd;
using Eigen::Vector2d;

Matrix2Xd without_repeats(const Matrix2Xd& points) {
  Matrix2Xd corners(2, points.cols());
  Eigen::Index count = 0;
  for (Eigen::Index i = 0; i < points.cols(); ++i) {
    if (count == 0 || points.col(i) != corners.col(count - 1)) corners.col(count++) = points.col(i);
  }
  return corners.leftCols(count);
}

// The curve from b to c at `share` of the way, by the pyramid of Barry and Goldman: each
// knot is the square root of a distance after the one before.
Vector2d catmull_rom(const std::array<Vector2d, 4>& p, double share) {
  std::array<double, 4> knot{};
  for (std::size_t i = 1; i < 4; ++i) knot[i] = knot[i - 1] + std::sqrt((p[i] - p[i - 1]).norm());
  const double t = knot[1] + share * (knot[2] - knot[1]);
  std::array<Vector2d, 4> row = p;
  for (std::size_t level = 1; level < 4; ++level) {
    for (std::size_t i = 0; i + level < 4; ++i) {
      // Only the two middle knots bound the last level.
      const double from = level == 3 ? knot[1] : knot[i],
                   to = level == 3 ? knot[2] : knot[i + level];
      row[i] += (t - from) / (to - from) * (row[i + 1] - row[i]);
    }
  }
  return row[0];
}

// The corner, or beyond the ends the last leg gone on.
Vector2d corner(const Matrix2Xd& corners, Eigen::Index i) {
  const Eigen::Index last = corners.cols() - 1;
  if (i < 0) return 2 * corners.col(0) - corners.col(1);
  if (i > last) return 2 * corners.col(last) - corners.col(last - 1);
  return corners.col(i);
}

}  // namespace

std::optional<std::string> trouble_with_path(const Matrix2Xd& points) {
  if (points.cols() < 2) return "a path needs at least two points";
  if (!points.allFinite()) return "the points of a path are numbers of metres";
  const Eigen::Vector2d size = points.rowwise().maxCoeff() - points.rowwise().minCoeff();
  if (size.norm() < least_path_m) return "all points of the path lie in one place";
  return {};
}

GroundPath::GroundPath(const Matrix2Xd& points, const std::string& source) {
  if (const auto trouble = trouble_with_path(points)) throw InputError(source, *trouble);
  corners_ = without_repeats(points);
  reached_ = {0};
  for (Eigen::Index i = 1; i < corners_.cols(); ++i) {
    reached_.push_back(reached_.back() + (corners_.col(i) - corners_.col(i - 1)).norm());
  }
  const std::size_t steps = 2 * reached_.size();
  steps_per_m_ = static_cast<double>(steps) / length();
  for (std::size_t step = 0, leg = 0; step < steps; ++step) {
    const double metres = static_cast<double>(step) / steps_per_m_;
    while (leg + 2 < reached_.size() && reached_[leg + 1] <= metres) ++leg;
    leg_of_step_.push_back(static_cast<int>(leg));
  }
}

std::size_t GroundPath::leg(double metres) const {
  const double step = std::floor(std::max(metres, 0.0) * steps_per_m_);
  const std::size_t last_step = leg_of_step_.size() - 1;
  const std::size_t at =
      step < static_cast<double>(last_step) ? static_cast<std::size_t>(step) : last_step;
  auto leg = static_cast<std::size_t>(leg_of_step_[at]);
  while (leg > 0 && reached_[leg] > metres) --leg;  // where the step was rounded
  while (leg + 2 < reached_.size() && reached_[leg + 1] <= metres) ++leg;
  return leg;
}

Vector2d GroundPath::at(double metres) const {
  const std::size_t from = leg(metres);
  const auto column = static_cast<Eigen::Index>(from);
  const double share = (metres - reached_[from]) / (reached_[from + 1] - reached_[from]);
  return corners_.col(column) +
         std::clamp(share, 0.0, 1.0) * (corners_.col(column + 1) - corners_.col(column));
}

Vector2d GroundPath::direction(double metres) const {
  const auto column = static_cast<Eigen::Index>(leg(metres));
  return (corners_.col(column + 1) - corners_.col(column)).normalized();
}

Matrix2Xd smooth_path(const Matrix2Xd& points, double step_m) {
  if (trouble_with_path(points)) return points;
  const Matrix2Xd corners = without_repeats(points);
  std::vector<Vector2d> curve;
  for (Eigen::Index i = 0; i + 1 < corners.cols(); ++i) {
    const std::array<Vector2d, 4> around{corner(corners, i - 1), corner(corners, i),
                                         corner(corners, i + 1), corner(corners, i + 2)};
    // A curve is at most half as long again as its chord, near enough.
    const double chord = (around[2] - around[1]).norm();
    const int steps = std::max(1, static_cast<int>(std::ceil(1.5 * chord / step_m)));
    for (int k = 0; k < steps; ++k) curve.push_back(catmull_rom(around, double(k) / steps));
  }
  curve.push_back(corners.col(corners.cols() - 1));
  Matrix2Xd smooth(2, static_cast<Eigen::Index>(curve.size()));
  for (std::size_t i = 0; i < curve.size(); ++i)
    smooth.col(static_cast<Eigen::Index>(i)) = curve[i];
  return smooth;
}

}  // namespace promenade::motion
