#include <fmt/format.h>

#include <algorithm>

#include "analysis/format.h"
#include "analysis/item.h"
#include "analysis/report/figures/kinds.h"
#include "analysis/report/figures/style.h"
#include "analysis/report/gnuplot.h"
#include "motion/models/dendrogram_layout.h"

namespace promenade::analysis {
namespace {

constexpr double row_mm = 3.3;  // of a name in 8 pt

// What hangs in the tree, by name, and where it is cut: nowhere without clusters.
struct Tree {
  const motion::Dendrogram& tree;
  const std::vector<std::string>& names;
  std::vector<int> cluster;                     // of each leaf
  std::vector<std::string> cluster_names = {};  // C
};

// Rows from below, from 1.
motion::DendrogramLayout layout_of(const motion::Dendrogram& tree) {
  motion::DendrogramLayout layout = motion::dendrogram_layout(tree);
  for (double& row : layout.rows) row = tree.leaves - row;
  return layout;
}

// Each merge is a bracket of four points, an empty line parts them. Its cluster counts from 1;
// 0: it joins several.
Table brackets(const Tree& of, const motion::DendrogramLayout& layout) {
  const motion::Dendrogram& tree = of.tree;
  Table table{"", "", {"height", "row", "merge", "examples"}, {}};
  std::vector<int> clusters;
  if (!of.cluster.empty()) {
    table.columns = {"height", "row", "merge", "pairs", "cluster"};
    clusters = motion::clusters_of_nodes(tree, of.cluster);
  }
  for (int i = 0; i < size_of(tree.merges); ++i) {
    const motion::Merge& merge = item(tree.merges, i);
    const auto add = [&](double height, int node) {
      auto& row = table.rows.emplace_back(
          std::vector<Cell>{Cell(height), Cell(item(layout.rows, node)), Cell(std::int64_t{i + 1}),
                            Cell(std::int64_t{merge.size})});
      if (clusters.empty()) return;
      row.emplace_back(std::int64_t{item(clusters, tree.leaves + i) + 1});
    };
    add(motion::height_of(tree, merge.a), merge.a);
    add(merge.height, merge.a);
    add(merge.height, merge.b);
    add(motion::height_of(tree, merge.b), merge.b);
    table.rows.emplace_back();
  }
  return table;
}

Table names_in(const Tree& of, const motion::DendrogramLayout& layout,
               const std::string& table_name) {
  const bool clustered = !of.cluster.empty();
  Table table{table_name, "", {"row", clustered ? "pair" : "example"}, {}};
  if (clustered) table.columns.emplace_back("cluster");
  for (const int leaf : layout.order) {
    table.rows.push_back({Cell(item(layout.rows, leaf)), Cell(item(of.names, leaf))});
    if (clustered) table.rows.back().emplace_back(item(of.cluster_names, item(of.cluster, leaf)));
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

Frame frame_of(const Tree& of, const std::string& x_label) {
  double widest = 0;
  for (const std::string& name : of.names) widest = std::max(widest, text_mm(name));
  Frame frame;
  frame.left_mm = std::clamp(widest + 4, 12.0, 42.0);
  frame.plot_mm = row_mm * static_cast<double>(of.names.size());
  frame.x_label = x_label;
  frame.series = of.cluster_names;
  frame.lines = true;
  for (int c = 0; c < size_of(of.cluster_names); ++c) frame.looks.push_back(c);
  return frame;
}

// Brackets in the look of their cluster, those above the cut in grey.
std::string plot_of(const Tree& of, const std::string& name) {
  if (of.cluster.empty())
    return fmt::format("plot '{}.csv' using 1:2 with lines lw 1.2 lc rgb '#0072b2'", name);
  const auto lines = [&](int cluster, const std::string& style) {
    return fmt::format("'{}.csv' using 1:($5=={}?$2:NaN) with lines {}", name, cluster, style);
  };
  std::string plot = "plot " + lines(0, "lw 1.2 lc rgb '#777777'");
  for (int c = 0; c < size_of(of.cluster_names); ++c) plot += ", " + lines(c + 1, line_style(c));
  return plot;
}

std::string cut_line(const Tree& of) {
  if (of.cluster.empty()) return "";
  return fmt::format(
      "set arrow from first {0},graph 0 to first {0},graph 1 nohead dt (3,3) lw 0.8 lc rgb "
      "'#444444'\n",
      motion::cut_height(of.tree, size_of(of.cluster_names)));
}

// Without title and caption; nothing where all leaves are the same.
std::optional<Figure> draw_tree(const Tree& of, const std::string& name,
                                const std::string& x_label) {
  if (of.tree.merges.empty() || !(of.tree.merges.back().height > 0)) return std::nullopt;
  const motion::DendrogramLayout layout = layout_of(of.tree);
  const Frame frame = frame_of(of, x_label);
  const FramedPlot framing = framed(frame);
  const double top = of.tree.merges.back().height;
  Figure figure;
  figure.task = -1;
  figure.name = name;
  figure.width_mm = frame.width_mm;
  figure.height_mm = framing.height_mm;
  figure.data = {brackets(of, layout), names_in(of, layout, name + "-names")};
  figure.setup = framing.commands +
                 fmt::format("set xrange [0:{}]\nset xtics {}\nset yrange [0.5:{}.5]\n", top * 1.04,
                             round_step(top), of.names.size()) +
                 row_names(layout, of.names, frame.left_mm - 3) +
                 "set grid xtics noytics lc rgb '#dddddd' lw 0.6 dt 1\nset border 1\n" +
                 cut_line(of);
  figure.plot = plot_of(of, name);
  return figure;
}

// "quickness (12), ...", as they stand from the top.
std::string clusters_from_top(const Tree& of) {
  std::vector<int> seen;
  std::vector<std::string> words;
  for (const int leaf : motion::dendrogram_layout(of.tree).order) {
    const int cluster = item(of.cluster, leaf);
    if (std::find(seen.begin(), seen.end(), cluster) != seen.end()) continue;
    seen.push_back(cluster);
    words.push_back(fmt::format("{} ({})", item(of.cluster_names, cluster),
                                std::count(of.cluster.begin(), of.cluster.end(), cluster)));
  }
  return listed(words);
}

}  // namespace

std::optional<Figure> dendrogram(const Results& results) {
  const MapTimes& times = results.map_times;
  auto figure =
      draw_tree({times.tree, times.names, {}}, "dendrogram", "Distance at which motions merge");
  if (!figure) return figure;
  figure->title = "How alike the motions are";
  figure->caption = fmt::format(
      "The {} examples of the motion set, clustered by Ward's method on what shapes the map "
      "(rotations of the joints and heights of the pelvis). Further to the right: less alike.",
      times.names.size());
  return figure;
}

std::optional<Figure> dendrogram_of_pairs(const Results& results) {
  if (!results.rated_pairs || !results.rated_pairs->problem.empty()) return std::nullopt;
  const RatedPairs& rated = *results.rated_pairs;
  const study::AdjectiveModel& model = rated.model;
  const Tree tree{model.quantification.tree, model.kept_pairs, model.quantification.cluster,
                  model.names};
  auto figure = draw_tree(tree, "dendrogram_pairs", "Distance at which pairs merge");
  if (!figure) return figure;
  figure->title = "Which pairs of adjectives mean the same";
  figure->caption = fmt::format(
      "The {} kept pairs, clustered by Ward's method on the mean ratings of {} ({}). Clusters, "
      "from "
      "the top: {}. The vertical line cuts the tree; grey joins clusters.",
      model.kept_pairs.size(), count_of(size_of(model.table.motions), "motion", "motions"),
      count_of(model.table.raters, "rater", "raters") +
          (rated.simulated > 0 ? fmt::format(", {} of them simulated", rated.simulated) : ""),
      clusters_from_top(tree));
  return figure;
}

}  // namespace promenade::analysis
