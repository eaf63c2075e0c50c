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

// What dots and labels cover, in the order in which the labels are placed.
class Sheet {
 public:
  Sheet(const Matrix2Xd& dots, double radius, const LabelRoom& room)
      : radius_(radius), inside_{0.5 * (room.low + room.high), 0.5 * (room.high - room.low)} {
    for (const auto& dot : dots.colwise()) taken_.push_back({dot, Vector2d::Constant(radius)});
  }

  struct Place {
    Rectangle label;
    double cost = std::numeric_limits<double>::infinity();  // what it covers and leaves, an area
  };

  // The best of the places around a dot; of equal ones the first.
  Place best_around(const Vector2d& dot, const Vector2d& half) const {
    Place best{{dot, half}};
    for (const double gap : {1.7 * radius_, 3.4 * radius_}) {
      for (const auto& [x, y] : places) {
        const Vector2d away = Vector2d(x, y).cwiseProduct(half + Vector2d::Constant(gap));
        const Rectangle label{dot + away, half};
        double cost = 2 * (area(label) - shared_area(label, inside_));
        for (const Rectangle& other : taken_) cost += shared_area(label, other);
        if (cost <= best.cost - rounding) best = {label, cost};
      }
    }
    return best;
  }

  void take(const Rectangle& label) { taken_.push_back(label); }

 private:
  double radius_;
  Rectangle inside_;
  std::vector<Rectangle> taken_;
};

Vector2d half_of(double width, double height) { return {0.5 * width, 0.5 * height}; }

}  // namespace

std::vector<LabelSpot> place_labels(const Matrix2Xd& dots, const std::vector<double>& widths,
                                    double height, double radius, const LabelRoom& room) {
  Sheet sheet(dots, radius, room);
  std::vector<LabelSpot> spots;
  for (Index i = 0; i < dots.cols(); ++i) {
    const double width = widths[static_cast<std::size_t>(i)];
    const Sheet::Place best = sheet.best_around(dots.col(i), half_of(width, height));
    sheet.take(best.label);
    spots.push_back({best.label.middle});
  }
  return spots;
}

std::vector<std::optional<LabelSpot>> place_labels_with_room(const Matrix2Xd& dots,
                                                             const std::vector<double>& widths,
                                                             double height, double radius,
                                                             const LabelRoom& room) {
  Sheet sheet(dots, radius, room);
  std::vector<std::optional<LabelSpot>> spots(static_cast<std::size_t>(dots.cols()));
  for (Index i = 0; i < dots.cols(); ++i) {
    const double width = widths[static_cast<std::size_t>(i)];
    const Sheet::Place best = sheet.best_around(dots.col(i), half_of(width, height));
    if (best.cost > rounding) continue;
    sheet.take(best.label);
    spots[static_cast<std::size_t>(i)] = LabelSpot{best.label.middle};
  }
  return spots;
}

}  // namespace promenade::analysis
