#include "app/path_picture.h"

#include <fmt/format.h>

#include <algorithm>

#include "analysis/pictures/label_colours.h"
#include "app/cluster_colours.h"

namespace promenade::app {
namespace {

using Eigen::Vector2d;

// At 1280 x 720, pixels.
constexpr float dash = 7, gap = 5, line_width = 2.5f, least_cell = 12;

float away(const ImVec2& a, const ImVec2& b) { return std::hypot(b.x - a.x, b.y - a.y); }

ImVec2 between(const ImVec2& a, const ImVec2& b, float share) {
  return {a.x + share * (b.x - a.x), a.y + share * (b.y - a.y)};
}

// Lines along a way, in one colour at a time.
class Pen {
 public:
  explicit Pen(float width) : width_(width) {}
  ~Pen() { lift(); }
  Pen(const Pen&) = delete;
  Pen& operator=(const Pen&) = delete;

  void take(const Rgb& colour) {
    if (colour == colour_) return;
    const bool goes_on = !line_.empty();
    const ImVec2 last = goes_on ? line_.back() : ImVec2();
    lift();
    colour_ = colour;
    if (goes_on) line_.push_back(last);
  }
  void to(const ImVec2& at) { line_.push_back(at); }
  void lift() {
    if (line_.size() > 1) {
      ImGui::GetWindowDrawList()->AddPolyline(line_.data(), static_cast<int>(line_.size()),
                                              packed(colour_), 0, width_);
    }
    line_.clear();
  }

 private:
  float width_;
  Rgb colour_ = Rgb::Zero();
  std::vector<ImVec2> line_;
};

// A pen that is lifted again and again.
class DashedPen {
 public:
  DashedPen(float width, float dash_px, float gap_px) : pen_(width), lengths_{dash_px, gap_px} {}

  void take(const Rgb& colour) { pen_.take(colour); }
  void to(const ImVec2& at) {
    if (!last_) {
      pen_.to(at);
      last_ = at;
      return;
    }
    while (true) {
      const float left = lengths_[gap_now_] - done_;
      const float way = away(*last_, at);
      if (way < left) {
        done_ += way;
        break;
      }
      last_ = between(*last_, at, way > 0 ? left / way : 1);
      done_ = 0;
      gap_now_ = 1 - gap_now_;
      pen_.to(*last_);
      if (gap_now_ == 1) pen_.lift();
    }
    last_ = at;
    if (gap_now_ == 0) pen_.to(at);
  }

 private:
  Pen pen_;
  std::array<float, 2> lengths_;
  std::size_t gap_now_ = 0;
  float done_ = 0;
  std::optional<ImVec2> last_;
};

// The label that is wanted after so many metres; empty: any.
const std::string& label_at(const WantedPath& path, double metres) {
  static const std::string any;
  for (const motion::PathPart& part : path.parts) {
    if (metres >= part.from_m && metres < part.to_m) return part.label;
  }
  return any;
}

}  // namespace

StyleColours::StyleColours(const motion::MotionGraph& graph)
    : all_(analysis::LabelColours(graph).labels()) {
  for (const std::string& label : all_) {
    const bool walks = std::any_of(graph.edges.begin(), graph.edges.end(),
                                   [&](const auto& edge) { return graph.label(edge) == label; });
    if (walks) labels_.push_back(label);
  }
}

Rgb StyleColours::of(const std::string& label) const {
  if (label.empty()) return cluster_colour(-1);
  return cluster_colour(
      static_cast<int>(std::lower_bound(all_.begin(), all_.end(), label) - all_.begin()));
}

double grid_step(const GroundPlan& plan, float least_pixels) {
  double step = 1;
  for (const double wider : {2.0, 5.0, 10.0}) {
    if (step * plan.unit() < least_pixels) step = wider;
  }
  return step;
}

ImVec2 PathPicture::pixel(const Vector2d& at) const {
  const Eigen::Vector2f there = plan_.pixel(at);
  return {there.x(), there.y()};
}

void PathPicture::draw_line(const Vector2d& from, const Vector2d& to, const Rgb& colour) const {
  const ImVec2 a = pixel(from), b = pixel(to);
  const float thick = ui_.layout.size(1);
  fill({std::round(std::min(a.x, b.x)), std::round(std::min(a.y, b.y)),
        std::max(thick, std::abs(a.x - b.x)), std::max(thick, std::abs(a.y - b.y))},
       colour);
}

void PathPicture::draw_grid() const {
  const Palette& palette = ui_.look.palette;
  const double step = grid_step(plan_, ui_.layout.size(least_cell));
  const Vector2d low = plan_.place({plan_.box.right(), plan_.box.bottom()});
  const Vector2d high = plan_.place({plan_.box.x, plan_.box.y});
  const auto colour = [&](double at) {
    return Rgb(std::abs(at) < 0.5 * step ? palette.line : palette.background);
  };
  for (double x = std::ceil(low.x() / step) * step; x <= high.x(); x += step) {
    draw_line({x, low.y()}, {x, high.y()}, colour(x));
  }
  for (double z = std::ceil(low.y() / step) * step; z <= high.y(); z += step) {
    draw_line({low.x(), z}, {high.x(), z}, colour(z));
  }
}

// Lighter than what is walked.
Rgb PathPicture::wanted_colour(const std::string& label) const {
  if (label.empty()) return rgb(0x9aa0a8);
  return 0.55f * colours_.of(label) + 0.45f * Rgb::Ones();
}

void PathPicture::draw_wanted(const WantedPath& path) const {
  DashedPen pen(ui_.layout.size(line_width), ui_.layout.size(dash), ui_.layout.size(gap));
  double metres = 0;
  for (Eigen::Index i = 0; i < path.points.cols(); ++i) {
    if (i > 0) metres += (path.points.col(i) - path.points.col(i - 1)).norm();
    pen.to(pixel(path.points.col(i)));
    pen.take(wanted_colour(label_at(path, metres)));
  }
}

void PathPicture::draw_walked(const WalkedWay& walked) const {
  Pen pen(ui_.layout.size(line_width));
  const auto last = walked.way.cols() - 1;
  for (const motion::LabelledPart& part : walked.labels) {
    pen.take(colours_.of(part.label));
    ImVec2 before(-1e6f, -1e6f);
    for (Eigen::Index f = part.from; f <= std::min<Eigen::Index>(part.to, last); ++f) {
      const ImVec2 at = pixel(walked.way.col(f));
      if (away(before, at) < ui_.layout.size(1) && f < last) continue;
      pen.to(at);
      before = at;
    }
  }
}

void PathPicture::draw_corner(const Vector2d& at, const std::string& label) const {
  ImDrawList* list = ImGui::GetWindowDrawList();
  list->AddCircleFilled(pixel(at), ui_.layout.size(4), packed(colours_.of(label)), 20);
}

void PathPicture::draw_walker(const Vector2d& at, const Vector2d& heading) const {
  const Palette& palette = ui_.look.palette;
  ImDrawList* list = ImGui::GetWindowDrawList();
  const ImVec2 middle = pixel(at);
  const ImVec2 ahead(static_cast<float>(-heading.x()), static_cast<float>(-heading.y()));
  const auto point = [&](float forward, float aside) {
    return ImVec2(middle.x + forward * ahead.x - aside * ahead.y,
                  middle.y + forward * ahead.y + aside * ahead.x);
  };
  const float radius = ui_.layout.size(6);
  const auto draw = [&](float rim, const Rgb& colour) {
    list->AddCircleFilled(middle, radius + rim, packed(colour), 32);
    list->AddTriangleFilled(point(3.1f * radius + 2.0f * rim, 0),
                            point(1.35f * radius - 0.5f * rim, 0.75f * radius + 1.3f * rim),
                            point(1.35f * radius - 0.5f * rim, -0.75f * radius - 1.3f * rim),
                            packed(colour));
  };
  draw(ui_.layout.size(2), palette.on_colour);
  draw(0, palette.current);
}

// At the rim of the plane, on the side from which the figure is seen.
void PathPicture::draw_camera(const Vector2d& to_camera) const {
  const ImVec2 out(static_cast<float>(-to_camera.x()), static_cast<float>(-to_camera.y()));
  const float half = 0.5f * plan_.box.width - ui_.layout.size(10);
  const float reach = half / std::max(std::abs(out.x), std::abs(out.y));
  const auto point = [&](float back, float aside) {
    const float far = reach - back;
    return ImVec2(plan_.box.middle_x() + far * out.x - aside * out.y,
                  plan_.box.middle_y() + far * out.y + aside * out.x);
  };
  const float size = ui_.layout.size(9);
  ImDrawList* list = ImGui::GetWindowDrawList();
  const ImU32 colour = packed(ui_.look.palette.quiet);
  list->AddCircleFilled(point(0, 0), 0.5f * size, colour, 20);
  list->AddLine(point(0, 0), point(1.8f * size, size), colour, ui_.layout.size(1.5f));
  list->AddLine(point(0, 0), point(1.8f * size, -size), colour, ui_.layout.size(1.5f));
}

void PathPicture::draw_cursor(const Vector2d& at) const {
  const ImVec2 middle = pixel(at);
  const float half = ui_.layout.size(9), thick = ui_.layout.size(2);
  const Rgb& colour = ui_.look.palette.text;
  fill({middle.x - half, middle.y - thick / 2, 2 * half, thick}, colour);
  fill({middle.x - thick / 2, middle.y - half, thick, 2 * half}, colour);
}

void PathPicture::draw_scale() const {
  const Palette& palette = ui_.look.palette;
  const double step = grid_step(plan_, ui_.layout.size(30));
  const float inset = ui_.layout.size(12), thick = ui_.layout.size(2);
  const float wide = std::round(static_cast<float>(step) * plan_.unit());
  const Box bar{plan_.box.x + inset, plan_.box.bottom() - inset, wide, thick};
  const std::string words = fmt::format("{} m", step);
  const Box text{bar.x, bar.y - ui_.layout.size(22), ui_.layout.size(60), ui_.layout.size(20)};
  fill({text.x - thick, text.y, text_width(ui_.look.fonts.text, words) + 2 * thick, text.height},
       palette.on_colour);
  fill(bar, palette.quiet);
  draw_text(ui_.look.fonts.text, text, palette.quiet, words);
}

}  // namespace promenade::app
