#include "analysis/pictures/way_picture.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "analysis/pictures/label_colours.h"
#include "analysis/pictures/svg.h"

namespace promenade::analysis {
namespace {

using Eigen::Vector2d;

constexpr int width = 1280, height = 820;
constexpr double left = 60, right = 1040, top = 90, bottom = 780;
constexpr const char* quiet_colour = "#6a6f78";
constexpr const char* wanted_colour = "#9aa0a8";

// From metres to the paper.
struct Ground {
  Vector2d middle = Vector2d::Zero();
  double scale = 1;  // pixels per metre

  explicit Ground(const WayPicture& picture) {
    Vector2d low = Vector2d::Constant(1e300), high = Vector2d::Constant(-1e300);
    for (const auto* way : {&picture.wanted, &picture.walked}) {
      if (way->cols() == 0) continue;
      low = low.cwiseMin(way->rowwise().minCoeff());
      high = high.cwiseMax(way->rowwise().maxCoeff());
    }
    middle = 0.5 * (low + high);
    const Vector2d size = (high - low).cwiseMax(Vector2d::Constant(1)) * 1.1;
    scale = std::min((right - left) / size.x(), (bottom - top) / size.y());
  }
  Vector2d operator()(const Vector2d& at) const {
    const Vector2d from_middle = scale * (at - middle);
    return {0.5 * (left + right) - from_middle.x(), 0.5 * (top + bottom) - from_middle.y()};
  }
};

std::vector<Vector2d> on_paper(const Ground& ground, const Eigen::Matrix2Xd& way, Eigen::Index from,
                               Eigen::Index to) {
  std::vector<Vector2d> points;
  for (Eigen::Index f = from; f <= std::min(to, way.cols() - 1); ++f) {
    points.push_back(ground(way.col(f)));
  }
  return points;
}

void draw_grid(Svg& svg, const Ground& ground) {
  double step = 0.5;
  for (const double wider : {1.0, 2.0, 5.0, 10.0, 20.0, 50.0, 100.0, 1000.0}) {
    if (step * ground.scale < 40) step = wider;
  }
  const double reach_x = 0.5 * (right - left) / ground.scale;
  const double reach_z = 0.5 * (bottom - top) / ground.scale;
  for (double x = std::ceil((ground.middle.x() - reach_x) / step) * step;
       x <= ground.middle.x() + reach_x; x += step) {
    const double at = ground({x, 0}).x();
    svg.line(at, top, at, bottom, "#eceef1");
  }
  for (double z = std::ceil((ground.middle.y() - reach_z) / step) * step;
       z <= ground.middle.y() + reach_z; z += step) {
    const double at = ground({0, z}).y();
    svg.line(left, at, right, at, "#eceef1");
  }
  svg.line(left, bottom + 14, left + step * ground.scale, bottom + 14, quiet_colour, 2);
  svg.words(left + step * ground.scale + 8, bottom + 19, fmt::format("{} m", step), "start",
            quiet_colour, 12);
}

void draw_start(Svg& svg, const Ground& ground, const Eigen::Matrix2Xd& way) {
  const Vector2d at = ground(way.col(0));
  svg.dot(at.x(), at.y(), 6, "#16181c");
  svg.words(at.x() + 12, at.y() + 5, "start", "start", "#16181c", 12);
}

void draw_walked(Svg& svg, const Ground& ground, const WayPicture& picture,
                 const LabelColours& colours) {
  if (picture.labels.empty()) {
    svg.curve(on_paper(ground, picture.walked, 0, picture.walked.cols()), "#0072b2", 2.4);
  }
  for (const motion::LabelledPart& part : picture.labels) {
    svg.curve(on_paper(ground, picture.walked, part.from, part.to), colours.colour(part.label),
              2.4);
  }
}

void draw_legend(Svg& svg, const WayPicture& picture, const LabelColours& colours) {
  double y = top + 10;
  const auto entry = [&](const std::string& words, const std::string& colour, bool dashed) {
    svg.curve({{right + 24, y}, {right + 60, y}}, colour, dashed ? 3 : 2.4, dashed ? "7 5" : "");
    svg.words(right + 70, y + 4, words, "start", colour);
    y += 24;
  };
  if (picture.wanted.cols() > 0) entry("wanted", wanted_colour, true);
  std::set<std::string> seen;
  for (const motion::LabelledPart& part : picture.labels) seen.insert(part.label);
  if (seen.empty()) entry("walked", "#0072b2", false);
  for (const std::string& label : seen) entry(label, colours.colour(label), false);
}

}  // namespace

std::string way_picture(const WayPicture& picture, const motion::MotionGraph& graph) {
  const LabelColours colours(graph);
  const Ground ground(picture);
  Svg svg(width, height);
  svg.words(24, 36, picture.title, "start", "#16181c", 20);
  svg.words(24, 60, picture.note, "start", quiet_colour);
  draw_grid(svg, ground);
  if (picture.wanted.cols() > 0) {
    svg.curve(on_paper(ground, picture.wanted, 0, picture.wanted.cols()), wanted_colour, 3, "7 5");
  }
  draw_walked(svg, ground, picture, colours);
  if (picture.walked.cols() > 0) draw_start(svg, ground, picture.walked);
  draw_legend(svg, picture, colours);
  return svg.finish();
}

}  // namespace promenade::analysis
