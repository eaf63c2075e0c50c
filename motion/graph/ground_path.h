// A way over the ground that somebody is to walk: a polyline with its arc length.
#pragma once

#include <Eigen/Dense>
#include <optional>
#include <string>
#include <vector>

namespace promenade::motion {

// What is wrong with points (2 x n; x and z, metres) as a path: fewer than two, some that are no
// numbers, or all in one place. Nothing: they are a path.
std::optional<std::string> trouble_with_path(const Eigen::Matrix2Xd& points);

inline constexpr double least_path_m = 0.01;  // across; what is smaller is a place

class GroundPath {
 public:
  // Throws an InputError that names `source` where there is trouble_with_path(). Points in the
  // place of the one before are left out.
  explicit GroundPath(const Eigen::Matrix2Xd& points, const std::string& source = "path");

  double length() const { return reached_.back(); }  // metres
  // The point after so many metres of the way, held at both ends. O(1) but for corners that lie
  // close together.
  Eigen::Vector2d at(double metres) const;
  // Direction (length 1) of the way there; at a corner, of the way that follows.
  Eigen::Vector2d direction(double metres) const;
  const Eigen::Matrix2Xd& corners() const { return corners_; }

 private:
  std::size_t leg(double metres) const;  // the number of its first corner

  Eigen::Matrix2Xd corners_;      // 2 x c
  std::vector<double> reached_;   // c: metres of the way at each corner
  std::vector<int> leg_of_step_;  // the leg on which each of equal steps of the way begins
  double steps_per_m_ = 0;
};

// A smooth curve through the points (centripetal Catmull-Rom), as points at most `step_m` apart;
// for drawn points, so that a figure need not turn on the spot. Points that are no path come
// back as they are.
Eigen::Matrix2Xd smooth_path(const Eigen::Matrix2Xd& points, double step_m = 0.05);

}  // namespace promenade::motion
