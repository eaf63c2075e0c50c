#include "analysis/pictures/cycle_picture.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "analysis/pictures/svg.h"
#include "motion/angles.h"

namespace promenade::analysis {
namespace {

using motion::CycleCandidate;
using motion::CycleReport;
using motion::FootCourse;
using motion::Stance;
using motion::TakeRecord;

constexpr int width = 1280, height = 720;
constexpr double plot_left = 84, plot_right = 880;  // of everything over time
constexpr const char* title_colour = "#16181c";
constexpr const char* left_colour = "#2266aa";
constexpr const char* right_colour = "#cc4433";
constexpr const char* chosen_colour = "#f2c14e";
constexpr const char* quiet_colour = "#8a8f98";

// Frames of a take as places on the paper.
struct TimeAxis {
  double from = 0, to = 1;  // frames
  double seconds_of_frame = 1;
  int first_frame = 0;

  double x(double frame) const {
    const double share = (frame - from) / std::max(to - from, 1e-9);
    return plot_left + std::clamp(share, 0.0, 1.0) * (plot_right - plot_left);
  }
};

// Seconds of the file under an axis, at round steps.
void draw_seconds(Svg& svg, const TimeAxis& axis, double y) {
  const auto seconds = [&](double frame) {
    return (frame + axis.first_frame) * axis.seconds_of_frame;
  };
  const double span = seconds(axis.to) - seconds(axis.from);
  double step = 0.1;
  for (const double wider : {0.2, 0.5, 1.0, 2.0, 5.0, 10.0, 20.0, 60.0, 120.0}) {
    if (span / step > 12) step = wider;
  }
  const auto last = static_cast<int>(std::floor(seconds(axis.to) / step));
  for (int k = static_cast<int>(std::ceil(seconds(axis.from) / step)); k <= last; ++k) {
    const double x = axis.x(k * step / axis.seconds_of_frame - axis.first_frame);
    svg.line(x, y, x, y + 4, quiet_colour);
    svg.words(x, y + 18, fmt::format("{:.{}f}", k * step, step < 1 ? 1 : 0), "middle", quiet_colour,
              11);
  }
  svg.line(plot_left, y, plot_right, y, quiet_colour);
  svg.words(plot_right + 8, y + 5, "s", "start", quiet_colour, 11);
}

void draw_stances(Svg& svg, const TimeAxis& axis, const std::vector<Stance>& stances, double y,
                  const char* colour) {
  for (const Stance& stance : stances) {
    if (stance.off < axis.from || stance.on > axis.to) continue;
    svg.rect(axis.x(stance.on), y, axis.x(stance.off) - axis.x(stance.on), 10, colour);
  }
}

void draw_contacts(Svg& svg, const TimeAxis& axis, const TakeRecord& take, double y) {
  svg.words(plot_left - 8, y + 10, "left", "end", left_colour);
  svg.words(plot_left - 8, y + 26, "right", "end", right_colour);
  draw_stances(svg, axis, take.contacts.left, y, left_colour);
  draw_stances(svg, axis, take.contacts.right, y + 16, right_colour);
}

void draw_take(Svg& svg, const TakeRecord& take, const CycleCandidate& cut) {
  const double frames = static_cast<double>(take.contacts.left_course.speed.size()) - 1;
  const TimeAxis axis{0, frames, take.frame_time, take.first_frame};
  svg.words(plot_left, 66,
            fmt::format("the take: when feet stand, {} cycles found, the chosen one in yellow",
                        take.cycles.size()),
            "start", quiet_colour);
  svg.rect(axis.x(cut.first()), 74, axis.x(cut.keys.back()) - axis.x(cut.first()), 58,
           chosen_colour);
  draw_contacts(svg, axis, take, 80);
  for (const CycleCandidate& cycle : take.cycles) {
    svg.rect(axis.x(cycle.first()) + 1, 118, axis.x(cycle.keys.back()) - axis.x(cycle.first()) - 2,
             6, "#50565f");
  }
  svg.words(plot_left - 8, 126, "cycles", "end", "#50565f");
  draw_seconds(svg, axis, 134);
}

// What is drawn of both feet in one plot.
struct Plot {
  const char* title;
  std::vector<double> FootCourse::*values;
  double top, bottom;  // on the paper
  double most, step;   // of the values
};

void draw_course(Svg& svg, const TimeAxis& axis, const FootCourse& course, const Plot& plot,
                 const char* colour) {
  const std::vector<double>& values = course.*plot.values;
  std::vector<Eigen::Vector2d> points;
  const auto from = static_cast<std::size_t>(std::max(std::ceil(axis.from), 0.0));
  for (std::size_t f = from; f < values.size() && static_cast<double>(f) <= axis.to; ++f) {
    const double share = std::clamp(values[f] / plot.most, -0.05, 1.0);
    points.emplace_back(axis.x(static_cast<double>(f)),
                        plot.bottom - share * (plot.bottom - plot.top));
  }
  svg.curve(points, colour);
}

void draw_plot(Svg& svg, const TimeAxis& axis, const TakeRecord& take, const Plot& plot) {
  svg.words(plot_left, plot.top - 6, plot.title, "start", quiet_colour);
  const int lines = static_cast<int>(std::lround(plot.most / plot.step));
  for (int k = 0; k <= lines; ++k) {
    const double value = k * plot.step;
    const double y = plot.bottom - value / plot.most * (plot.bottom - plot.top);
    svg.line(plot_left, y, plot_right, y, "#e4e6ea");
    svg.words(plot_left - 8, y + 4, fmt::format("{:.1f}", value), "end", quiet_colour, 11);
  }
  draw_course(svg, axis, take.contacts.left_course, plot, left_colour);
  draw_course(svg, axis, take.contacts.right_course, plot, right_colour);
}

void draw_feet(Svg& svg, const TakeRecord& take, const CycleCandidate& cut, bool walk) {
  const double frames = static_cast<double>(take.contacts.left_course.speed.size()) - 1;
  const double margin = 0.4 * cut.length();
  const TimeAxis axis{std::max(cut.first() - margin, 0.0),
                      std::min(cut.keys.back() + margin, frames), take.frame_time,
                      take.first_frame};
  svg.rect(axis.x(cut.first()), 172, axis.x(cut.keys.back()) - axis.x(cut.first()), 502, "#fdf5dd");
  draw_plot(
      svg, axis, take,
      {"height of the sole over where it stands, m", &FootCourse::sole_height, 216, 396, 0.3, 0.1});
  draw_plot(svg, axis, take,
            {"speed of the slower of ankle and toe, m/s", &FootCourse::speed, 436, 596, 5, 1});
  const double still = 596 - take.contacts.still_m_s / 5 * 160;
  svg.line(plot_left, still, plot_right, still, "#50565f");
  svg.words(plot_right + 6, still + 4, "stands", "start", "#50565f", 11);
  draw_contacts(svg, axis, take, 614);
  const std::array<const char*, 5> names = {"right off", "right on", "left off", "left on",
                                            "right off"};
  for (std::size_t k = 0; k < cut.keys.size(); ++k) {
    const double x = axis.x(cut.keys[k]);
    svg.line(x, 176, x, 660, "#50565f");
    // Landing and leaving lie close together: their names go to either side.
    const bool before = k == 1 || k == 3;
    const std::string name = walk ? names[k] : fmt::format("key {}", k);
    svg.words(x + (before ? -4 : 4), 184, name, before ? "end" : "start", "#50565f", 11);
  }
  draw_seconds(svg, axis, 674);
}

using Body = Eigen::Matrix<double, 3, motion::body_joint_count>;

// A body as sticks, seen along X (its left side) or along Z (from behind).
void draw_body(Svg& svg, const Body& body, double x, bool side, const char* colour, double thick) {
  constexpr double metre = 165, ground = 640;
  const auto at = [&](int joint) {
    const Eigen::Vector3d p = body.col(joint);
    return Eigen::Vector2d(x + metre * (side ? p.z() : -p.x()), ground - metre * p.y());
  };
  for (int b = 1; b < motion::body_joint_count; ++b) {
    const Eigen::Vector2d from = at(motion::body_parent(static_cast<motion::BodyJoint>(b)));
    const Eigen::Vector2d to = at(b);
    svg.line(from.x(), from.y(), to.x(), to.y(), colour, thick);
  }
}

void draw_seam(Svg& svg, const CycleReport& report) {
  constexpr double side = 1000, front = 1180, top = 240;
  svg.words(920, top - 20, "the seam: first pose, last pose, and", "start", quiet_colour);
  svg.words(920, top, "where both went (from the side, from behind)", "start", quiet_colour);
  svg.line(930, 640, 1260, 640, quiet_colour);
  for (const auto& [x, from_side] : {std::pair{side, true}, {front, false}}) {
    draw_body(svg, report.closed, x, from_side, "#c9ccd2", 7);
    draw_body(svg, report.first, x, from_side, "#2a9d6f", 2);
    draw_body(svg, report.last, x, from_side, "#8e44ad", 2);
  }
  svg.words(930, 670, "first", "start", "#2a9d6f");
  svg.words(985, 670, "last", "start", "#8e44ad");
  svg.words(1040, 670, "in the set", "start", quiet_colour);
}

void draw_figures(Svg& svg, const motion::Cycle& cycle, const CycleReport& report) {
  const auto millimetres = [](double metres) { return fmt::format("{:.1f} mm", 1e3 * metres); };
  const std::array<std::pair<const char*, std::string>, 6> lines = {{
      {"gap before it was closed", millimetres(cycle.loop_error_m)},
      {"jump at the seam, in 1/60 s", millimetres(report.seam.gap_m)},
      {"largest jump inside", millimetres(report.seam.inside_m)},
      {"slide of a standing foot",
       millimetres(std::max(report.slide_left_m, report.slide_right_m))},
      {"most that a joint was moved", millimetres(report.from_capture_m)},
      {"turn that was taken out",
       fmt::format("{:.1f} degrees", cycle.origin.turn / motion::degree)},
  }};
  double y = 80;
  for (const auto& [name, value] : lines) {
    svg.words(920, y, name, "start", quiet_colour);
    svg.words(1256, y, value, "end");
    y += 21;
  }
}

}  // namespace

std::string cycle_picture(const motion::BuiltSet& built, const CycleReport& report) {
  const auto index = static_cast<std::size_t>(motion::find_cycle(built.set, report.cycle));
  const motion::Cycle& cycle = built.set.cycles[index];
  Svg svg(width, height);
  svg.words(plot_left, 34, cycle.name, "start", title_colour, 20);
  svg.words(plot_right, 34,
            fmt::format("{}, frames {} to {}, {:.2f} s", cycle.source, cycle.first_frame,
                        cycle.first_frame + cycle.frames, cycle.seconds),
            "end", quiet_colour);
  const TakeRecord& take = built.takes[static_cast<std::size_t>(report.take)];
  draw_take(svg, take, report.cut);
  draw_feet(svg, take, report.cut, built.set.walk);
  draw_seam(svg, report);
  draw_figures(svg, cycle, report);
  return svg.finish();
}

}  // namespace promenade::analysis
