#include "analysis/pictures/dendrogram_picture.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "analysis/item.h"
#include "analysis/pictures/map_picture_parts.h"
#include "analysis/report/gnuplot.h"
#include "motion/models/dendrogram_layout.h"

namespace promenade::analysis {
namespace {

// Apart for colour-blind readers, dark enough for words.
constexpr std::array colours = {"#0072b2", "#d55e00", "#009e73", "#a03a78",
                                "#8a6d00", "#3a86b8", "#555555", "#7a4fb5"};
constexpr double row = 18;      // pixels, of a leaf and of a line below
constexpr double letter = 6.6;  // of the small font
constexpr double width = 900;

const char* colour_of(int cluster) {
  return cluster < 0 ? "#888888" : colours[static_cast<std::size_t>(cluster) % colours.size()];
}

int characters(const std::string& text) {
  return static_cast<int>(
      std::count_if(text.begin(), text.end(), [](char c) { return (c & 0xC0) != 0x80; }));
}

double widest(const std::vector<std::string>& texts, double least, double most) {
  int longest = 0;
  for (const std::string& text : texts) longest = std::max(longest, characters(text));
  return std::clamp(letter * longest + 14, least, most);
}

// Lines below the tree, in columns as wide as they need.
struct Columns {
  int count = 1, rows = 0;
  double wide = width;
};

Columns columns_of(const std::vector<std::string>& dropped) {
  Columns columns;
  columns.wide = widest(dropped, 200, width - 40);
  columns.count = std::max(1, static_cast<int>((width - 40) / columns.wide));
  columns.rows = (size_of(dropped) + columns.count - 1) / columns.count;
  return columns;
}

struct Plan {
  Frame frame;
  Columns columns;
  motion::DendrogramLayout layout;
  double cut = 0;  // as a cost
};

double cost_of(double height) { return height * height / 2; }

Plan plan_of(const DendrogramPicture& picture) {
  Plan plan;
  plan.layout = motion::dendrogram_layout(picture.tree);
  plan.columns = columns_of(picture.dropped);
  const double below = 60 + (picture.dropped.empty() ? 0 : row * (plan.columns.rows + 1) + 14);
  const double above = 44 + row * size_of(picture.warnings);
  const double height = below + row * std::max(3, size_of(picture.leaves)) + above;
  plan.frame = {width,
                height,
                widest(picture.leaves, 60, 320),
                width - widest(picture.names, 60, 240) - 16,
                below,
                height - above};
  plan.cut = cost_of(motion::cut_height(picture.tree, size_of(picture.names)));
  return plan;
}

double top_cost(const DendrogramPicture& picture, const Plan& plan) {
  const double top = picture.tree.merges.empty() ? 1 : picture.tree.merges.back().cost();
  return 1.08 * std::max({top, plan.cut, 1e-9});
}

std::string label(const std::string& text, const std::string& at, const char* align,
                  const char* colour, int size = 9) {
  return fmt::format("set label {} at {} {} front font ',{}' tc rgb '{}'\n", gnuplot_text(text), at,
                     align, size, colour);
}

// Round costs, not too close on the square-root scale.
std::string cost_tics(double top) {
  std::vector<double> tics = {0};
  const double room = 0.07 * std::sqrt(top);
  for (double power = 1e-12; power < top; power *= 10) {
    for (const double step : {1.0, 2.0, 5.0}) {
      const double tic = step * power;
      if (tic < top && std::sqrt(tic) - std::sqrt(tics.back()) > room) tics.push_back(tic);
    }
  }
  std::string text;
  for (const double tic : tics)
    text += fmt::format("{}'{:.4g}' {}", text.empty() ? "" : ", ", tic, tic);
  return "set xtics (" + text + ") nomirror scale 0.4 tc rgb '#444444' font ',9'\n";
}

// Pixels from the lower left of the picture.
std::string at_pixel(const Frame& frame, double x, double y) {
  return fmt::format("screen {},{}", x / frame.width, y / frame.height);
}

double pixel_of_row(const DendrogramPicture& picture, const Frame& frame, double at) {
  const double leaves = std::max(1, size_of(picture.leaves));
  return frame.top - (frame.top - frame.bottom) * (at + 0.5) / leaves;
}

std::string leaf_labels(const DendrogramPicture& picture, const Plan& plan) {
  std::string text;
  for (int i = 0; i < size_of(picture.leaves); ++i) {
    const double y = pixel_of_row(picture, plan.frame, item(plan.layout.rows, i));
    text += label(item(picture.leaves, i), at_pixel(plan.frame, plan.frame.left - 8, y), "right",
                  colour_of(item(picture.cluster, i)));
  }
  return text;
}

// A bar along the rows of each cluster, and its name beside it.
std::string cluster_labels(const DendrogramPicture& picture, const Plan& plan) {
  std::string text;
  for (int c = 0; c < size_of(picture.names); ++c) {
    double first = size_of(picture.leaves), last = -1;
    for (int i = 0; i < size_of(picture.leaves); ++i) {
      if (item(picture.cluster, i) != c) continue;
      first = std::min(first, item(plan.layout.rows, i));
      last = std::max(last, item(plan.layout.rows, i));
    }
    const double x = plan.frame.right + 8;
    const double high = pixel_of_row(picture, plan.frame, first - 0.4);
    const double low = pixel_of_row(picture, plan.frame, last + 0.4);
    text += fmt::format("set arrow from {} to {} nohead lw 4 lc rgb '{}'\n",
                        at_pixel(plan.frame, x, high), at_pixel(plan.frame, x, low), colour_of(c));
    text += label(item(picture.names, c), at_pixel(plan.frame, x + 8, (high + low) / 2), "left",
                  colour_of(c), 10);
  }
  return text;
}

std::string words_around(const DendrogramPicture& picture, const Plan& plan) {
  const Frame& frame = plan.frame;
  std::string text =
      label(picture.title, at_pixel(frame, 20, frame.height - 18), "left", "#222222", 12);
  for (int i = 0; i < size_of(picture.warnings); ++i) {
    text += label(item(picture.warnings, i), at_pixel(frame, 20, frame.height - 40 - row * i),
                  "left", "#c01818", 10);
  }
  if (picture.dropped.empty()) return text;
  const double top = frame.bottom - 66;
  text += label(fmt::format("Left out ({}):", picture.dropped.size()), at_pixel(frame, 20, top),
                "left", "#222222", 10);
  for (int i = 0; i < size_of(picture.dropped); ++i) {
    const double x = 20 + plan.columns.wide * (i / plan.columns.rows);
    const double y = top - row * (1 + i % plan.columns.rows);
    text += label(item(picture.dropped, i), at_pixel(frame, x, y), "left", "#555555");
  }
  return text;
}

// Each merge is a bracket in the colour of its cluster, grey above the cut.
std::string brackets(const DendrogramPicture& picture, const Plan& plan) {
  const std::vector<int> nodes = motion::clusters_of_nodes(picture.tree, picture.cluster);
  std::string data = "$tree << EOD\n";
  for (int t = 0; t < size_of(picture.tree.merges); ++t) {
    const motion::Merge& merge = item(picture.tree.merges, t);
    const int colour = std::stoi(colour_of(item(nodes, picture.tree.leaves + t)) + 1, nullptr, 16);
    const auto add = [&](double cost, int node) {
      data += fmt::format("{} {} {}\n", cost, item(plan.layout.rows, node), colour);
    };
    add(cost_of(motion::height_of(picture.tree, merge.a)), merge.a);
    add(merge.cost(), merge.a);
    add(merge.cost(), merge.b);
    add(cost_of(motion::height_of(picture.tree, merge.b)), merge.b);
    data += "\n";
  }
  return data + "EOD\n";
}

}  // namespace

void draw_dendrogram(const DendrogramPicture& picture, const std::filesystem::path& file) {
  const Plan plan = plan_of(picture);
  std::string script = place(plan.frame);
  script += "set encoding utf8\nset border 1 lc rgb '#888888'\nset key off\nunset ytics\n";
  script += "set nonlinear x via sqrt(x) inverse x**2\n";
  script += cost_tics(top_cost(picture, plan));
  script += fmt::format("set xrange [0:{}]\nset yrange [{}:-0.5]\n", top_cost(picture, plan),
                        std::max(1, size_of(picture.leaves)) - 0.5);
  script += "set xlabel 'Cost of a merge (square-root scale); dashed: the cut' font ',10'\n";
  script += fmt::format(
      "set arrow from first {0},graph 0 to first {0},graph 1 nohead dt (12,8) lw 1.5 lc rgb "
      "'#222222'\n",
      plan.cut);
  script +=
      leaf_labels(picture, plan) + cluster_labels(picture, plan) + words_around(picture, plan);
  script += brackets(picture, plan);
  script += picture.tree.merges.empty()
                ? "plot NaN"
                : "plot $tree using 1:2:3 with lines lw 1.6 lc rgb variable";
  draw_script(script, plan.frame, file);
}

}  // namespace promenade::analysis
