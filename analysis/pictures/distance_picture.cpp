#include "analysis/pictures/distance_picture.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "analysis/pictures/label_colours.h"
#include "analysis/pictures/svg.h"

namespace promenade::analysis {
namespace {

constexpr int cells = 400;  // at the most, each way
constexpr double left = 150, top = 130, side = 720;
constexpr const char* quiet_colour = "#6a6f78";
constexpr const char* used_colour = "#d55e00";
constexpr const char* refused_colour = "#ffffff";

// Dark blue where frames are the same, pale where they have nothing in common; equal steps of
// lightness, so that it can be read in grey print.
constexpr std::array shades = {"#12264a", "#1c3c6b", "#2a548a", "#3f6ea4", "#5b88b9",
                               "#7ba2ca", "#9cbad8", "#bdd1e5", "#dbe6f0", "#f3f6f9"};

// Places on the paper.
struct Paper {
  const motion::MapPicture& map;
  double cell;

  explicit Paper(const motion::MapPicture& picture)
      : map(picture), cell(side / static_cast<double>(picture.rms.rows())) {}
  double windows() const { return map.starts_down.back(); }
  double at(int take, double start) const {
    return (map.starts_down[static_cast<std::size_t>(take)] + start) / windows() * side;
  }
};

// Where the shades change: so that a tenth of the cells has each, the first with half of that,
// since what is alike is what people look for.
std::vector<float> steps_of(const Eigen::MatrixXf& rms) {
  std::vector<float> values;
  for (const float value : rms.reshaped()) {
    if (std::isfinite(value)) values.push_back(value);
  }
  std::sort(values.begin(), values.end());
  std::vector<float> steps;
  for (std::size_t s = 0; s + 1 < shades.size() && !values.empty(); ++s) {
    const double share = 0.02 + 0.98 * std::pow(static_cast<double>(s + 1) / shades.size(), 1.5);
    const auto at = static_cast<std::size_t>(share * static_cast<double>(values.size() - 1));
    steps.push_back(values[at]);
  }
  return steps;
}

std::size_t shade_of(const std::vector<float>& steps, float value) {
  return static_cast<std::size_t>(std::lower_bound(steps.begin(), steps.end(), value) -
                                  steps.begin());
}

// Cells of one shade that lie side by side are one piece of one path: a picture of a hundred
// thousand cells stays small.
void draw_cells(Svg& svg, const Paper& paper, const std::vector<float>& steps) {
  std::vector<std::string> paths(shades.size());
  const Eigen::MatrixXf& rms = paper.map.rms;
  for (Eigen::Index y = 0; y < rms.rows(); ++y) {
    for (Eigen::Index x = 0; x < rms.cols();) {
      const std::size_t shade = shade_of(steps, rms(y, x));
      Eigen::Index end = x + 1;
      while (end < rms.cols() && shade_of(steps, rms(y, end)) == shade) ++end;
      fmt::format_to(std::back_inserter(paths[shade]), "M{} {}h{}v1h-{}z", x, y, end - x, end - x);
      x = end;
    }
  }
  svg.open_frame(left, top, paper.cell);
  for (std::size_t shade = 0; shade < shades.size(); ++shade) svg.area(paths[shade], shades[shade]);
  svg.close_frame();
}

// A line where one take ends, and its name where there is room.
void draw_takes(Svg& svg, const Paper& paper, const motion::MotionGraph& graph) {
  const LabelColours colours(graph);
  double last_words = -1000;
  for (std::size_t t = 0; t < graph.takes.size(); ++t) {
    const double from = paper.at(static_cast<int>(t), 0), to = paper.at(static_cast<int>(t) + 1, 0);
    if (t > 0) {
      svg.line(left + from, top, left + from, top + side, "#ffffff", 0.6);
      svg.line(left, top + from, left + side, top + from, "#ffffff", 0.6);
    }
    const double middle = top + 0.5 * (from + to);
    if (middle - last_words < 12 || to <= from) continue;
    last_words = middle;
    svg.words(left - 8, middle + 4, graph.takes[t].label, "end",
              colours.colour(graph.takes[t].label), 11);
  }
}

void draw_matches(Svg& svg, const Paper& paper, const motion::BuiltGraph& built) {
  const double radius = std::clamp(40 / std::sqrt(built.statistics.matches + 1.0), 0.8, 3.0);
  const int k = built.graph.window;
  const auto dots = [&](int from, int to, const motion::TransitionFrames& frames,
                        const char* colour) {
    svg.dot(left + paper.at(to, frames.j - k + 1), top + paper.at(from, frames.i), radius, colour);
  };
  for (const motion::RefusedTransition& one : built.refusals) {
    dots(one.from_take, one.to_take, one.frames, refused_colour);
  }
  for (const motion::GraphEdge& edge : built.graph.edges) {
    if (edge.transition < 0) continue;
    const auto take = [&](int node) { return built.graph.node(node).take; };
    dots(take(edge.from), take(edge.to), built.graph.transition(edge.transition).frames,
         used_colour);
  }
}

void draw_legend(Svg& svg, const std::vector<float>& steps) {
  const double x = left + side + 40;
  svg.words(x, top + 12, "distance of two windows, m (RMS)", "start", quiet_colour);
  for (std::size_t s = 0; s < shades.size(); ++s) {
    const double y = top + 28 + 22 * static_cast<double>(s);
    svg.rect(x, y, 28, 22, shades[s]);
    if (s < steps.size()) {
      svg.words(x + 38, y + 26, fmt::format("{:.3f}", steps[s]), "start", quiet_colour, 11);
    }
  }
  const double y = top + 28 + 22 * static_cast<double>(shades.size()) + 34;
  svg.dot(x + 6, y, 4, used_colour);
  svg.words(x + 20, y + 4, "a transition of the graph", "start", quiet_colour);
  svg.dot(x + 6, y + 24, 5, quiet_colour);
  svg.dot(x + 6, y + 24, 4, refused_colour);
  svg.words(x + 20, y + 28, "alike, but refused", "start", quiet_colour);
  svg.words(x, y + 64, "row: left there; column: entered there", "start", quiet_colour);
}

}  // namespace

motion::MapPicture distances_of(const motion::MotionGraph& graph) {
  const Eigen::VectorXd weights = motion::joint_weights(graph.skeleton(), graph.body());
  std::vector<motion::Clouds> clouds;
  for (const auto& one : graph.takes) clouds.push_back(motion::joint_clouds(one.take, weights));
  std::vector<const motion::Clouds*> all;
  for (const motion::Clouds& one : clouds) all.push_back(&one);
  return motion::map_picture(all, all, motion::window_taper(graph.options, graph.frame_time), cells,
                             cells);
}

std::string distance_picture(const motion::BuiltGraph& built, const motion::MapPicture& map) {
  Svg svg(1280, 890);
  svg.words(24, 36, "How alike moments are: " + built.graph.name, "start", "#16181c", 20);
  svg.words(
      24, 60,
      fmt::format("{} takes end to end, {} windows of {:.2f} s; {} places below {:.3f} m",
                  built.graph.takes.size(), map.starts_down.empty() ? 0 : map.starts_down.back(),
                  built.graph.window * built.graph.frame_time, built.statistics.matches,
                  built.graph.threshold_m),
      "start", quiet_colour);
  if (map.rms.size() == 0) return svg.finish();
  const Paper paper(map);
  const std::vector<float> steps = steps_of(map.rms);
  draw_cells(svg, paper, steps);
  draw_takes(svg, paper, built.graph);
  draw_matches(svg, paper, built);
  draw_legend(svg, steps);
  return svg.finish();
}

}  // namespace promenade::analysis
