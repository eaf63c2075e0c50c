#include <fmt/format.h>

#include <algorithm>

#include "analysis/item.h"
#include "analysis/report/figures/kinds.h"
#include "analysis/report/figures/style.h"
#include "analysis/report/gnuplot.h"
#include "motion/models/dendrogram_layout.h"

namespace promenade::analysis {
namespace {

constexpr double row_mm = 3.3;  // of a name in 8 pt

// Rows from below, from 1.
motion::DendrogramLayout layout_of(const motion::Dendrogram& tree) {
  motion::DendrogramLayout layout = motion::dendrogram_layout(tree);
  for (double& row : layout.rows) row = tree.leaves - row;
  return layout;
}

// Each merge is a bracket of four points, an empty line parts them.
Table brackets(const motion::Dendrogram& tree, const motion::DendrogramLayout& layout) {
  Table table{"", "", {"height", "row", "merge", "examples"}, {}};
  for (int i = 0; i < size_of(tree.merges); ++i) {
    const motion::Merge& merge = item(tree.merges, i);
    const auto add = [&](double height, int cluster) {
      table.rows.push_back({Cell(height), Cell(item(layout.rows, cluster)),
                            Cell(std::int64_t{i + 1}), Cell(std::int64_t{merge.size})});
    };
    add(motion::height_of(tree, merge.a), merge.a);
    add(merge.height, merge.a);
    add(merge.height, merge.b);
    add(motion::height_of(tree, merge.b), merge.b);
    table.rows.emplace_back();
  }
  return table;
}

Table names_in(const motion::DendrogramLayout& layout, const std::vector<std::string>& names,
               const std::string& table_name) {
  Table table{table_name, "", {"row", "example"}, {}};
  for (const int leaf : layout.order) {
    table.rows.push_back({Cell(item(layout.rows, leaf)), Cell(item(names, leaf))});
  }
  return table;
}

std::string row_names(const motion::DendrogramLayout& layout, const std::vector<std::string>& names,
                      double room_mm) {
  std::string tics;
  for (const int leaf : layout.order) {
    tics +=
        fmt::format("{}{} {}", tics.empty() ? "" : ", ",
                    gnuplot_text(fitted_mm(item(names, leaf), room_mm)), item(layout.rows, leaf));
  }
  return "set ytics (" + tics + ") scale 0\n";
}

Frame frame_of(const std::vector<std::string>& names) {
  double widest = 0;
  for (const std::string& name : names) widest = std::max(widest, text_mm(name));
  Frame frame;
  frame.left_mm = std::clamp(widest + 4, 12.0, 42.0);
  frame.plot_mm = row_mm * static_cast<double>(names.size());
  frame.x_label = "Distance at which motions merge";
  return frame;
}

}  // namespace

std::optional<Figure> dendrogram(const Results& results) {
  const motion::Dendrogram& tree = results.map_times.tree;
  const std::vector<std::string>& names = results.map_times.names;
  if (tree.merges.empty() || !(tree.merges.back().height > 0)) return std::nullopt;
  const motion::DendrogramLayout layout = layout_of(tree);
  const Frame frame = frame_of(names);
  const FramedPlot framing = framed(frame);
  const double top = tree.merges.back().height;
  Figure figure;
  figure.task = -1;
  figure.name = "dendrogram";
  figure.title = "How alike the motions are";
  figure.caption = fmt::format(
      "The {} examples of the motion set, clustered by Ward's method on what shapes the map "
      "(rotations of the joints and heights of the pelvis). Further to the right: less alike.",
      names.size());
  figure.width_mm = frame.width_mm;
  figure.height_mm = framing.height_mm;
  figure.data = {brackets(tree, layout), names_in(layout, names, figure.name + "-names")};
  figure.setup = framing.commands +
                 fmt::format("set xrange [0:{}]\nset xtics {}\nset yrange [0.5:{}.5]\n", top * 1.04,
                             round_step(top), names.size()) +
                 row_names(layout, names, frame.left_mm - 3) +
                 "set grid xtics noytics lc rgb '#dddddd' lw 0.6 dt 1\nset border 1\n";
  figure.plot =
      fmt::format("plot '{}.csv' using 1:2 with lines lw 1.2 lc rgb '#0072b2'", figure.name);
  return figure;
}

}  // namespace promenade::analysis
