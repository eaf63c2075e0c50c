#include "analysis/pictures/map_layout.h"

#include <algorithm>
#include <array>
#include <limits>

namespace promenade::analysis {
namespace {

using Eigen::Index;
using Eigen::Matrix2Xd;
using Eigen::Vector2d;

// Eight directions, the most pleasant to read first.
constexpr std::array<std::array<double, 2>, 8> places = {
    {{1, 0}, {-1, 0}, {0, 1}, {0, -1}, {1, 1}, {-1, 1}, {1, -1}, {-1, -1}}};

constexpr double rounding = 1e-6;  // square pixels

struct Rectangle {
  Vector2d middle, half;
};

double shared_area(const Rectangle& a, const Rectangle& b) {
  const Vector2d low = (a.middle - a.half).cwiseMax(b.middle - b.half);
  const Vector2d high = (a.middle + a.half).cwiseMin(b.middle + b.half);
  const Vector2d side = high - low;
  return side.minCoeff() <= 0 ? 0 : side.x() * side.y();
}

double area(const Rectangle& a) { return 4 * a.half.x() * a.half.y(); }

}  // namespace

std::vector<LabelSpot> place_labels(const Matrix2Xd& dots, const std::vector<double>& widths,
                                    double height, double radius, const LabelRoom& room) {
  const Rectangle inside{0.5 * (room.low + room.high), 0.5 * (room.high - room.low)};
  std::vector<Rectangle> taken;
  for (const auto& dot : dots.colwise()) {
    taken.push_back({dot, Vector2d::Constant(radius)});
  }
  std::vector<LabelSpot> spots;
  for (Index i = 0; i < dots.cols(); ++i) {
    const Vector2d half(0.5 * widths[static_cast<std::size_t>(i)], 0.5 * height);
    Rectangle best{dots.col(i), half};
    double least = std::numeric_limits<double>::infinity();
    for (const double gap : {1.7 * radius, 3.4 * radius}) {
      for (const auto& [x, y] : places) {
        const Vector2d away = Vector2d(x, y).cwiseProduct(half + Vector2d::Constant(gap));
        const Rectangle label{dots.col(i) + away, half};
        double cost = 2 * (area(label) - shared_area(label, inside));
        for (const Rectangle& other : taken) cost += shared_area(label, other);
        if (cost > least - rounding) continue;  // of equal places the first
        least = cost;
        best = label;
      }
    }
    taken.push_back(best);
    spots.push_back({best.middle});
  }
  return spots;
}

}  // namespace promenade::analysis
