#include <fmt/format.h>

#include <array>
#include <cmath>

#include "analysis/pictures/map_picture_parts.h"
#include "analysis/report/gnuplot.h"
#include "motion/angles.h"
#include "motion/models/centre_of_mass.h"

namespace promenade::analysis {
namespace {

using Eigen::Vector2d;
using motion::BodyPoints;

constexpr int figures = 6;         // of a strip, over the cycle
constexpr double apart = 0.95;     // metres between them
constexpr double view_angle = 35;  // degrees from the side toward the front
constexpr double head_radius = 0.1;
constexpr double words_width = 140;  // pixels, left of a strip

// Sides of the body, the far one first.
struct Limbs {
  const char* name;
  const char* colour;
  double width;                             // of the lines
  std::array<std::array<int, 2>, 6> bones;  // from and to: BodyJoint or Segment::Point
};

constexpr int hips = motion::Segment::mid_hip;

constexpr std::array<Limbs, 3> parts = {{
    {"left",
     "#8fb8d6",
     4,
     {{{motion::left_shoulder, motion::left_elbow},
       {motion::left_elbow, motion::left_wrist},
       {hips, motion::left_hip},
       {motion::left_hip, motion::left_knee},
       {motion::left_knee, motion::left_ankle},
       {motion::left_ankle, motion::left_toe}}}},
    {"trunk",
     "#4d4d4d",
     5.5,
     {{{hips, motion::chest},
       {motion::chest, motion::neck},
       {motion::neck, motion::head},
       {motion::left_shoulder, motion::neck},
       {motion::neck, motion::right_shoulder},
       {motion::left_hip, motion::right_hip}}}},
    {"right",
     "#0b4f7d",
     4,
     {{{motion::right_shoulder, motion::right_elbow},
       {motion::right_elbow, motion::right_wrist},
       {hips, motion::right_hip},
       {motion::right_hip, motion::right_knee},
       {motion::right_knee, motion::right_ankle},
       {motion::right_ankle, motion::right_toe}}}},
}};

// Seen from the right of the figure, which walks to the right.
Vector2d seen(const Eigen::Vector3d& at, int figure) {
  const double angle = view_angle * motion::pi / 180;
  return {at.z() * std::cos(angle) - at.x() * std::sin(angle) + figure * apart, at.y()};
}

std::vector<BodyPoints> bodies_of(const motion::MotionSpace& space,
                                  const Eigen::VectorXd& weights) {
  const motion::Cycle cycle = motion::blend(space, weights);
  std::vector<BodyPoints> bodies;
  for (int i = 0; i < figures; ++i) {
    const motion::Pose pose = motion::pose_at(space.set, cycle, static_cast<double>(i) / figures);
    bodies.push_back(motion::body_points(space.set.skeleton, space.set.body,
                                         motion::forward_kinematics(space.set.skeleton, pose)));
  }
  return bodies;
}

std::string limbs_data(const std::vector<BodyPoints>& bodies, const Limbs& limbs) {
  std::string text;
  for (int i = 0; i < figures; ++i) {
    const BodyPoints& body = bodies[static_cast<std::size_t>(i)];
    for (const auto& [from, to] : limbs.bones) {
      const Vector2d a = seen(body.col(from), i);
      const Vector2d b = seen(body.col(to), i);
      text += fmt::format("{} {}\n{} {}\n\n", a.x(), a.y(), b.x(), b.y());
    }
  }
  return text;
}

std::string heads_data(const std::vector<BodyPoints>& bodies) {
  std::string text;
  for (int i = 0; i < figures; ++i) {
    const BodyPoints& body = bodies[static_cast<std::size_t>(i)];
    const Vector2d at =
        seen(0.5 * (body.col(motion::head) + body.col(motion::Segment::head_top)), i);
    text += fmt::format("{} {} {}\n", at.x(), at.y(), head_radius);
  }
  return text;
}

// Left of the figures: the name of the heuristic, and what is said about it.
std::string words(const HeuristicStrip& strip, const Frame& frame) {
  const double left = (frame.left - words_width) / frame.width;
  const double top = frame.top - 28;
  std::string text =
      fmt::format("set label 1 {} at screen {},{} left font ',14' tc rgb '#222222'\n",
                  gnuplot_text(strip.heuristic), left, top / frame.height);
  for (std::size_t line = 0; line < strip.notes.size(); ++line) {
    text += fmt::format("set label {} {} at screen {},{} left font ',10' tc rgb '#666666'\n",
                        line + 2, gnuplot_text(strip.notes[line]), left,
                        (top - 24 - 15 * static_cast<double>(line)) / frame.height);
  }
  return text;
}

std::string strip_script(const motion::MotionSpace& space, const HeuristicStrip& strip, int row,
                         const Frame& frame) {
  const std::vector<BodyPoints> bodies = bodies_of(space, strip.weights);
  std::string text = place(frame) + "unset border\nunset tics\nunset xlabel\nunset ylabel\n";
  text += "unset label\nunset title\nunset xzeroaxis\nset yzeroaxis lw 0\nunset yzeroaxis\n";
  const double height = 1.95;
  const double width = height * (frame.right - frame.left) / (frame.top - frame.bottom);
  const double middle = 0.5 * (figures - 1) * apart;
  text += fmt::format("set xrange [{}:{}]\nset yrange [{}:{}]\n", middle - 0.5 * width,
                      middle + 0.5 * width, -0.06, height - 0.06);
  text += words(strip, frame);
  std::string plot = "plot 0 with lines lc rgb '#cccccc' lw 1";
  for (const Limbs& limbs : parts) {
    const std::string name = fmt::format("${}{}", limbs.name, row);
    text += name + " << EOD\n" + limbs_data(bodies, limbs) + "EOD\n";
    plot +=
        fmt::format(", {} using 1:2 with lines lw {} lc rgb '{}'", name, limbs.width, limbs.colour);
  }
  text += fmt::format("$heads{} << EOD\n{}EOD\n", row, heads_data(bodies));
  return text + plot +
         fmt::format(", $heads{} using 1:2:3 with circles fs solid 1 noborder lc rgb '#4d4d4d'\n",
                     row);
}

}  // namespace

void draw_heuristics(const MapPicture& picture, const motion::MotionSpace& space,
                     const Vector2d& point, const std::vector<HeuristicStrip>& strips,
                     const std::filesystem::path& file) {
  const double row_height = 170;
  Frame frame{1210, 50 + row_height * static_cast<double>(strips.size()), 0, 0, 0, 0};
  Frame map = frame;
  map.left = 60;
  map.right = 500;
  map.bottom = 0.5 * frame.height - 220;
  map.top = map.bottom + 440;
  std::string script =
      "set multiplot\nset title " + gnuplot_text(picture.title) + " tc rgb '#222222'\n";
  script += fmt::format("$point << EOD\n{} {}\nEOD\n", point.x(), point.y());
  script += map_script(picture, map, picture.names.size() <= 12) +
            ", $point using 1:2 with points pt 7 ps 1.3 lc rgb '#e8000b'\n";
  for (std::size_t row = 0; row < strips.size(); ++row) {
    Frame strip = frame;
    strip.left = 540 + words_width;
    strip.right = frame.width - 5;
    strip.top = frame.height - 25 - row_height * static_cast<double>(row);
    strip.bottom = strip.top - row_height + 8;
    script += strip_script(space, strips[row], static_cast<int>(row), strip);
  }
  draw_script(script + "unset multiplot", frame, file);
}

}  // namespace promenade::analysis
