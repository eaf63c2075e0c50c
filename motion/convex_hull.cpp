#include "motion/convex_hull.h"

#include <algorithm>

namespace promenade::motion {
namespace {

using Eigen::Matrix2Xd;
using Eigen::Vector2d;

double cross(const Vector2d& o, const Vector2d& a, const Vector2d& b) {
  return (a.x() - o.x()) * (b.y() - o.y()) - (a.y() - o.y()) * (b.x() - o.x());
}

// One half of the hull: turns left at every corner.
std::vector<int> half_hull(const Matrix2Xd& points, const std::vector<int>& order) {
  std::vector<int> hull;
  for (const int next : order) {
    while (hull.size() >= 2 && cross(points.col(hull[hull.size() - 2]), points.col(hull.back()),
                                     points.col(next)) <= 0) {
      hull.pop_back();
    }
    hull.push_back(next);
  }
  hull.pop_back();  // the other half begins with it
  return hull;
}

}  // namespace

std::vector<int> convex_hull(const Matrix2Xd& points, std::vector<int> columns) {
  if (columns.size() < 3) return columns;
  std::sort(columns.begin(), columns.end(), [&points](int a, int b) {
    return points(0, a) != points(0, b) ? points(0, a) < points(0, b) : points(1, a) < points(1, b);
  });
  std::vector<int> hull = half_hull(points, columns);
  std::reverse(columns.begin(), columns.end());
  const std::vector<int> upper = half_hull(points, columns);
  hull.insert(hull.end(), upper.begin(), upper.end());
  return hull;
}

}  // namespace promenade::motion
