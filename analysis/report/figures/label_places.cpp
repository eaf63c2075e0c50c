#include "analysis/report/figures/label_places.h"

#include <algorithm>

#include "analysis/report/figures/style.h"

namespace promenade::analysis {
namespace {

constexpr double dot_mm = 0.5;   // radius
constexpr double away_mm = 0.9;  // of a name from the middle of its dot

struct Box {
  double left = 0, right = 0, low = 0, high = 0;

  bool meets(const Box& other) const {
    return left < other.right && other.left < right && low < other.high && other.low < high;
  }
};

Box around(const Dot& dot) {
  return {dot.x_mm - dot_mm, dot.x_mm + dot_mm, dot.y_mm - dot_mm, dot.y_mm + dot_mm};
}

// The eight places around a dot, the best first.
std::vector<Box> places_of(const Dot& dot, double width, double height) {
  const double right = dot.x_mm + away_mm;
  const double left = dot.x_mm - away_mm - width;
  const double middle = dot.x_mm - width / 2;
  const double up = dot.y_mm + away_mm + height / 2;
  const double down = dot.y_mm - away_mm - height / 2;
  const double aside = away_mm / 2;
  std::vector<Box> boxes;
  const auto add = [&](double x, double y) {
    boxes.push_back({x, x + width, y - height / 2, y + height / 2});
  };
  add(right, dot.y_mm);
  add(left, dot.y_mm);
  add(middle, up);
  add(middle, down);
  for (const double y : {up, down}) {
    add(right - aside, y);
    add(left + aside, y);
  }
  return boxes;
}

}  // namespace

std::vector<std::optional<LabelPlace>> label_places(const std::vector<Dot>& dots, double width_mm,
                                                    double height_mm, double points) {
  std::vector<Box> taken;
  for (const Dot& dot : dots) taken.push_back(around(dot));
  std::vector<std::optional<LabelPlace>> result;
  for (const Dot& dot : dots) {
    std::optional<LabelPlace>& place = result.emplace_back();
    const double height = points * 25.4 / 72;
    for (const Box& box : places_of(dot, text_mm(dot.name) * points / 8, height)) {
      const bool inside =
          box.left >= 0 && box.right <= width_mm && box.low >= 0 && box.high <= height_mm;
      const bool free = std::none_of(taken.begin(), taken.end(),
                                     [&](const Box& other) { return box.meets(other); });
      if (!inside || !free) continue;
      place = LabelPlace{box.left, (box.low + box.high) / 2};
      taken.push_back(box);
      break;
    }
  }
  return result;
}

}  // namespace promenade::analysis
