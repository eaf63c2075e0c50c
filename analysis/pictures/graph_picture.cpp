#include "analysis/pictures/graph_picture.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "analysis/pictures/label_colours.h"
#include "analysis/pictures/svg.h"

namespace promenade::analysis {
namespace {

using Eigen::Vector2d;
using motion::BuiltGraph;
using motion::GraphEdge;
using motion::GraphNode;
using motion::MotionGraph;

constexpr double lines_left = 190, lines_right = 860;  // of the lines of time
constexpr double matrix_left = 1010, matrix_right = 1256;
constexpr double top = 112;
constexpr const char* quiet_colour = "#6a6f78";
constexpr const char* pale_colour = "#d8dbe0";
constexpr int most_bows = 1500;  // more would only be black

// Where things are on the paper.
struct Lines {
  const MotionGraph& graph;
  LabelColours colours;
  double row_height;
  double seconds;  // of the longest take

  explicit Lines(const MotionGraph& all) : graph(all), colours(all) {
    const double rows = static_cast<double>(graph.takes.size());
    row_height = std::clamp(540 / rows, 14.0, 60.0);
    int frames = 2;
    for (const auto& one : graph.takes) frames = std::max(frames, one.take.frames());
    seconds = (frames - 1) * graph.frame_time;
  }
  double y(int take) const { return top + (take + 0.5) * row_height; }
  double x(int frame) const {
    return lines_left + frame * graph.frame_time / seconds * (lines_right - lines_left);
  }
  Vector2d at(int node) const {
    const GraphNode& where = graph.node(node);
    return {x(where.frame), y(where.take)};
  }
  const std::string& label(int node) const {
    const int take = graph.node(node).take;
    return graph.take(take).label;
  }
  double bottom() const { return top + static_cast<double>(graph.takes.size()) * row_height; }
};

std::string shortened(const std::string& name, std::size_t most) {
  if (name.size() <= most) return name;
  std::size_t end = most - 1;
  while (end > 0 && (static_cast<unsigned char>(name[end]) & 0xc0U) == 0x80U) --end;
  return name.substr(0, end) + "…";
}

void draw_takes(Svg& svg, const Lines& lines) {
  const int size = std::clamp(static_cast<int>(lines.row_height) - 2, 10, 13);
  for (std::size_t t = 0; t < lines.graph.takes.size(); ++t) {
    const auto& one = lines.graph.takes[t];
    const double y = lines.y(static_cast<int>(t));
    svg.words(lines_left - 12, y + 4, shortened(one.label, 24), "end",
              lines.colours.colour(one.label), size);
    svg.line(lines_left, y, lines.x(one.take.frames() - 1), y, pale_colour, 3);
  }
  for (const GraphEdge& edge : lines.graph.edges) {
    if (edge.transition >= 0) continue;
    const Vector2d from = lines.at(edge.from), to = lines.at(edge.to);
    svg.line(from.x(), from.y(), to.x(), to.y(), lines.colours.colour(lines.label(edge.from)), 3);
  }
}

// The best ones, so that what is drawn does not depend on their order.
std::vector<const GraphEdge*> drawn_transitions(const MotionGraph& graph) {
  std::vector<const GraphEdge*> drawn;
  for (const GraphEdge& edge : graph.edges) {
    if (edge.transition >= 0) drawn.push_back(&edge);
  }
  const auto rms = [&graph](const GraphEdge* edge) {
    return graph.transition(edge->transition).rms_m;
  };
  std::stable_sort(drawn.begin(), drawn.end(),
                   [&](const GraphEdge* a, const GraphEdge* b) { return rms(a) < rms(b); });
  if (drawn.size() > most_bows) drawn.resize(most_bows);
  return drawn;
}

void draw_transitions(Svg& svg, const Lines& lines) {
  const auto drawn = drawn_transitions(lines.graph);
  const double opacity = std::clamp(30.0 / static_cast<double>(drawn.size() + 1), 0.12, 0.8);
  for (const GraphEdge* edge : drawn) {
    const Vector2d from = lines.at(edge->from), to = lines.at(edge->to);
    const Vector2d way = to - from;
    const Vector2d aside(-way.y(), way.x());
    const double bend = std::abs(way.y()) < 1 ? 0.25 : 0.1;
    svg.bow(from, 0.5 * (from + to) + bend * aside, to,
            lines.colours.colour(lines.label(edge->from)), opacity);
  }
}

void draw_time(Svg& svg, const Lines& lines) {
  double step = 0.5;
  for (const double wider : {1.0, 2.0, 5.0, 10.0, 20.0, 60.0, 120.0, 600.0}) {
    if (lines.seconds / step > 12) step = wider;
  }
  const double y = lines.bottom() + 8;
  svg.line(lines_left, y, lines_right, y, quiet_colour);
  for (int k = 0; k * step <= lines.seconds; ++k) {
    const double x = lines_left + k * step / lines.seconds * (lines_right - lines_left);
    svg.line(x, y, x, y + 4, quiet_colour);
    svg.words(x, y + 18, fmt::format("{:.{}f}", k * step, step < 1 ? 1 : 0), "middle", quiet_colour,
              11);
  }
  svg.words(lines_right + 8, y + 5, "s", "start", quiet_colour, 11);
}

using Counts = std::map<std::pair<int, int>, int>;

Counts counts_of(const Lines& lines) {
  Counts counts;
  for (const GraphEdge& edge : lines.graph.edges) {
    if (edge.transition < 0) continue;
    ++counts[{lines.colours.number(lines.label(edge.from)),
              lines.colours.number(lines.label(edge.to))}];
  }
  return counts;
}

// White to blue.
std::string shade(double share) {
  const auto mix = [share](int light, int dark) {
    return static_cast<int>(light + share * (dark - light));
  };
  return fmt::format("#{:02x}{:02x}{:02x}", mix(0xf2, 0x1f), mix(0xf5, 0x5f), mix(0xf9, 0xa8));
}

void draw_matrix(Svg& svg, const Lines& lines) {
  const auto& labels = lines.colours.labels();
  const double cell =
      std::min((matrix_right - matrix_left) / static_cast<double>(labels.size()), 60.0);
  const int size = std::clamp(static_cast<int>(cell) - 3, 8, 13);
  const Counts counts = counts_of(lines);
  int most = 1;
  for (const auto& [pair, count] : counts) most = std::max(most, count);
  svg.words(matrix_left - 120, 84, "transitions from (row) to (column)", "start", quiet_colour);
  const int numbers = static_cast<int>(labels.size());
  for (int row = 0; row < numbers; ++row) {
    const double y = top + row * cell;
    const std::string& label = labels[static_cast<std::size_t>(row)];
    svg.words(matrix_left - 8, y + cell / 2 + 4, shortened(label, 16), "end",
              lines.colours.colour(label), size);
    for (int column = 0; column < numbers; ++column) {
      const auto found = counts.find({row, column});
      const int count = found == counts.end() ? 0 : found->second;
      const double x = matrix_left + column * cell, share = static_cast<double>(count) / most;
      svg.rect(x, y, cell - 1, cell - 1, count == 0 ? "#f4f4f4" : shade(share));
      if (count == 0 || cell < 22) continue;
      svg.words(x + cell / 2, y + cell / 2 + 4, std::to_string(count), "middle",
                share > 0.5 ? "#ffffff" : "#30343a", 11);
    }
  }
}

std::string summary(const BuiltGraph& built) {
  const auto& s = built.statistics;
  return fmt::format(
      "{} nodes, {} transitions; {:.1f} of {:.1f} s of motion can be walked on from; "
      "RMS below {:.3f} m, {} transitions refused",
      s.nodes, s.transitions, s.seconds_kept, s.frames * built.graph.frame_time,
      built.graph.threshold_m, s.refused);
}

}  // namespace

std::string graph_picture(const BuiltGraph& built) {
  const Lines lines(built.graph);
  Svg svg(1280, static_cast<int>(std::max(lines.bottom() + 60, 420.0)));
  svg.words(24, 36, "Motion graph " + built.graph.name, "start", "#16181c", 20);
  svg.words(24, 60, summary(built), "start", quiet_colour);
  svg.words(lines_left, 84, "takes over time; grey: nothing leads on from there", "start",
            quiet_colour);
  draw_transitions(svg, lines);
  draw_takes(svg, lines);
  draw_time(svg, lines);
  draw_matrix(svg, lines);
  return svg.finish();
}

}  // namespace promenade::analysis
