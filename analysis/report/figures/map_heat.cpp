#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "analysis/format.h"
#include "analysis/item.h"
#include "analysis/pictures/map_layout.h"
#include "analysis/report/figures/kinds.h"
#include "analysis/report/figures/style.h"
#include "analysis/report/gnuplot.h"

namespace promenade::analysis {
namespace {

using Group = std::vector<const MapTime*>;

constexpr double small_points = 6;  // type of names in the map
constexpr double dot_mm = 0.5;      // radius of an example
constexpr const char* small_font = "font 'Noto Sans,6'";
constexpr double edge_mm = 3, gap_mm = 4;
constexpr double head_mm = 8.5;  // over a panel: its interface and its time
constexpr double legend_mm = 9;

// From grey to blue; each step holds shares of time from `least` on. Darker is more, so that
// grey print loses nothing, and names stay readable on all of them.
struct Step {
  double least;
  const char* colour;
};
constexpr std::array<Step, 6> steps = {{{0, "e3e5e7"},
                                        {0.005, "cad8e4"},
                                        {0.01, "a5c8e4"},
                                        {0.02, "77b0dc"},
                                        {0.05, "4595cf"},
                                        {0.1, "0078bd"}}};

// Where panels are, in millimetres from the lower left corner of the figure.
struct Sheet {
  double width_mm = 0, height_mm = 0;
  double panel_mm = 0, panel_height_mm = 0;
  int per_row = 1;

  double left(int panel) const { return edge_mm + panel % per_row * (panel_mm + gap_mm); }
  double below(int panel) const {
    return height_mm - (panel / per_row + 1) * (head_mm + panel_height_mm);
  }
};

// Panels have the proportions of the plane, unless that would make them flat or tall.
Sheet sheet_for(int panels, const study::CoverageMap& map) {
  Sheet sheet;
  sheet.width_mm = panels < 2 ? one_column_mm : two_columns_mm;
  sheet.per_row = panels == 4 ? 2 : std::min(panels, 3);
  sheet.panel_mm = (sheet.width_mm - 2 * edge_mm - (sheet.per_row - 1) * gap_mm) / sheet.per_row;
  const double ratio = map.cell(0) > 0 ? map.cell(1) / map.cell(0) : 1;
  sheet.panel_height_mm = sheet.panel_mm * std::clamp(ratio, 0.5, 1.0);
  const int rows = (panels + sheet.per_row - 1) / sheet.per_row;
  sheet.height_mm = rows * (head_mm + sheet.panel_height_mm) + legend_mm;
  return sheet;
}

// Of a point of the plane, in cells from the lower left corner of the map.
double in_cells(const study::CoverageMap& map, double at, int axis) {
  return map.cell(axis) > 0 ? (at - map.least(axis)) / map.cell(axis) : 0.5;
}

double middle_of(const study::CoverageMap& map, int cell, int axis) {
  return map.least(axis) + (cell + 0.5) * map.cell(axis);
}

Table cells_in(const Results& results, const Group& group) {
  const study::CoverageMap& map = results.map_times.map;
  Table table{
      "",
      "",
      {"panel", "column", "row", "share", "seconds", "component_1", "component_2", "interface"},
      {}};
  for (int panel = 0; panel < size_of(group); ++panel) {
    const MapTime& one = *item(group, panel);
    for (int cell = 0; cell < size_of(one.seconds); ++cell) {
      const double seconds = item(one.seconds, cell);
      if (!(seconds > 0)) continue;
      const int column = cell / map_cells;
      const int row = cell % map_cells;
      table.rows.push_back({Cell(std::int64_t{panel}), Cell(std::int64_t{column}),
                            Cell(std::int64_t{row}), Cell(seconds / one.total_s()), Cell(seconds),
                            Cell(middle_of(map, column, 0)), Cell(middle_of(map, row, 1)),
                            Cell(item(results.data.interfaces, one.interface))});
    }
  }
  return table;
}

Table panels_in(const Results& results, const Group& group, const std::string& name) {
  Table table{name, "", {"panel", "trials", "seconds", "seconds_beyond_edge", "interface"}, {}};
  for (int panel = 0; panel < size_of(group); ++panel) {
    const MapTime& one = *item(group, panel);
    table.rows.push_back({Cell(std::int64_t{panel}), Cell(std::int64_t{one.trials}),
                          Cell(one.total_s()), Cell(one.outside_s),
                          Cell(item(results.data.interfaces, one.interface))});
  }
  return table;
}

Table examples_in(const MapTimes& times, const std::string& name) {
  Table table{name, "", {"column", "row", "component_1", "component_2", "example"}, {}};
  for (int i = 0; i < size_of(times.names); ++i) {
    const Eigen::RowVector2d at = times.map.examples.row(i);
    table.rows.push_back({Cell(in_cells(times.map, at(0), 0)), Cell(in_cells(times.map, at(1), 1)),
                          Cell(at(0)), Cell(at(1)), Cell(item(times.names, i))});
  }
  return table;
}

// The examples in a panel of the sheet, their names, and where those have room; millimetres.
struct Names {
  Eigen::Matrix2Xd dots;
  std::vector<std::string> texts;
  std::vector<double> widths;
  std::vector<std::optional<LabelSpot>> spots;
};

Names names_on(const MapTimes& times, const Sheet& sheet) {
  Names names;
  names.dots.resize(2, size_of(times.names));
  for (int i = 0; i < size_of(times.names); ++i) {
    const Eigen::RowVector2d at = times.map.examples.row(i);
    names.dots.col(i) << in_cells(times.map, at(0), 0) / map_cells * sheet.panel_mm,
        in_cells(times.map, at(1), 1) / map_cells * sheet.panel_height_mm;
    names.texts.push_back(fitted(item(times.names, i), 12));
    names.widths.push_back(text_mm(names.texts.back()) * small_points / 8);
  }
  names.spots = place_labels_with_room(names.dots, names.widths, small_points * 25.4 / 72, dot_mm,
                                       {{0, 0}, {sheet.panel_mm, sheet.panel_height_mm}});
  return names;
}

std::string label(const std::string& text, double x, double y, const std::string& more) {
  return fmt::format("set label {} at {:.3f},{:.3f} {}\n", gnuplot_text(text), x, y, more);
}

std::string box(double left, double below, double width, double height, const std::string& style) {
  return fmt::format("set object rectangle from {:.3f},{:.3f} to {:.3f},{:.3f} {}\n", left, below,
                     left + width, below + height, style);
}

std::string share_text(double share) {
  return share > 0 && share < 0.001 ? "< 0.1" : fixed(share * 100, share < 0.0995 ? 1 : 0);
}

std::string panel_frame(const Results& results, const MapTime& one, const Sheet& sheet, int panel) {
  const double x = sheet.left(panel);
  const double y = sheet.below(panel);
  const double top = y + sheet.panel_height_mm;
  const std::string name = item(results.data.interfaces, one.interface);
  std::string time = fmt::format("{}, {} min", count_of(one.trials, "trial", "trials"),
                                 fixed(one.total_s() / 60, 1));
  if (one.outside_s > 0) {
    time += ", " + share_text(one.outside_s / one.total_s()) + " % beyond the edge";
  }
  return box(x, y, sheet.panel_mm, sheet.panel_height_mm,
             "front fs empty border lc rgb '#777777' lw 0.8") +
         label(fitted_mm(name, sheet.panel_mm), x, top + 5, "left") +
         label(time, x, top + 1.7, std::string("left tc rgb '#444444' ") + small_font);
}

std::string names_in_panel(const Names& names, const Sheet& sheet, int panel) {
  std::string commands;
  for (std::size_t i = 0; i < names.texts.size(); ++i) {
    if (!names.spots[i]) continue;
    const Eigen::Vector2d middle = names.spots[i]->at;
    commands += label(names.texts[i], sheet.left(panel) + middle.x() - names.widths[i] / 2,
                      sheet.below(panel) + middle.y(), std::string("left front ") + small_font);
  }
  return commands;
}

// "< 0.5", "0.5", "1", ..., with the least share of each step at its left end.
std::string legend(double width_mm) {
  const std::string title = "% of the time, per cell:";
  double x = std::min(edge_mm + text_mm(title) * small_points / 8 + 2, width_mm - 6 * 8.5);
  std::string commands = label(title, edge_mm, 4, std::string("left ") + small_font);
  for (std::size_t i = 0; i < steps.size(); ++i) {
    commands += box(x, 3.8, 8, 2, fmt::format("fs solid noborder fc rgb '#{}'", steps[i].colour));
    if (i > 0) {
      commands += label(fmt::format("{:g}", steps[i].least * 100), x, 1.8,
                        std::string("center ") + small_font);
    }
    x += 8;
  }
  return commands;
}

// gnuplot's functions: the colour of a share, and where a panel is.
std::string functions(const Sheet& sheet) {
  std::string colour;
  for (std::size_t i = steps.size(); i-- > 1;) {
    colour += fmt::format("share >= {} ? 0x{} : ", steps[i].least, steps[i].colour);
  }
  return fmt::format(
      "colour(share) = {}0x{}\n"
      "left(panel) = {:.3f} + {:.3f} * (int(panel) % {})\n"
      "below(panel) = {:.3f} - {:.3f} * (int(panel) / {} + 1)\n",
      colour, steps[0].colour, edge_mm, sheet.panel_mm + gap_mm, sheet.per_row, sheet.height_mm,
      head_mm + sheet.panel_height_mm, sheet.per_row);
}

std::string setup_of(const Results& results, const Group& group, const Sheet& sheet, int& named) {
  const Names names = names_on(results.map_times, sheet);
  named = static_cast<int>(std::count_if(names.spots.begin(), names.spots.end(),
                                         [](const auto& spot) { return spot.has_value(); }));
  std::string setup = fmt::format(
      "set lmargin at screen 0\nset rmargin at screen 1\nset bmargin at screen 0\n"
      "set tmargin at screen 1\nset xrange [0:{}]\nset yrange [0:{}]\n"
      "unset border\nunset grid\nunset xtics\nunset ytics\n",
      sheet.width_mm, sheet.height_mm);
  setup += functions(sheet) + legend(sheet.width_mm);
  for (int panel = 0; panel < size_of(group); ++panel) {
    setup += panel_frame(results, *item(group, panel), sheet, panel) +
             names_in_panel(names, sheet, panel);
  }
  return setup;
}

std::string plot_command(const std::string& name, const Group& group, const Sheet& sheet) {
  const double wide = sheet.panel_mm / map_cells;
  const double high = sheet.panel_height_mm / map_cells;
  return fmt::format(
      "plot '{0}.csv' using (left($1)+($2+0.5)*{1:.4f}):(below($1)+($3+0.5)*{2:.4f}):({3:.4f}):"
      "({4:.4f}):(colour($4)) with boxxyerror fs solid noborder lc rgb variable, \\\n"
      "  for [panel=0:{5}] '{0}-examples.csv' using (left(panel)+$1*{1:.4f}):"
      "(below(panel)+$2*{2:.4f}) with points pt 7 ps 0.2 lc rgb '#000000'",
      name, wide, high, wide / 2 - 0.1, high / 2 - 0.1, size_of(group) - 1);
}

std::string caption_of(const Results& results, int task, int named) {
  const MapTimes& times = results.map_times;
  std::string caption = fmt::format(
      "Where people spent their time{}: what they were shown, on the plane of the first two "
      "principal components of the motion set, in the {} x {} cells that map_coverage counts. "
      "Black dots are the examples{}.",
      in_task(results, task), map_cells, map_cells,
      named < size_of(times.names)
          ? fmt::format(", {} of {} with their names", named, times.names.size())
          : "");
  if (times.paused > 0) {
    caption += " " + capitalised(count_of(times.paused, "trial that was", "trials that were")) +
               " paused or interrupted stay out of it.";
  }
  if (times.other_set > 0) {
    caption += " " + capitalised(count_of(times.other_set, "trial", "trials")) +
               " of versions with another motion set stay out of it.";
  }
  return caption;
}

}  // namespace

std::optional<Figure> map_heat(const Results& results, int task) {
  Group group;
  for (const MapTime& one : results.map_times.times) {
    if (one.task == task) group.push_back(&one);
  }
  if (group.empty()) return std::nullopt;
  const Sheet sheet = sheet_for(size_of(group), results.map_times.map);
  int named = 0;
  Figure figure;
  figure.task = task;
  figure.name = figure_name(results, task, "map_time");
  figure.title = "Time on the map";
  figure.setup = setup_of(results, group, sheet, named);
  figure.caption = caption_of(results, task, named);
  figure.width_mm = sheet.width_mm;
  figure.height_mm = sheet.height_mm;
  figure.data = {cells_in(results, group),
                 examples_in(results.map_times, figure.name + "-examples"),
                 panels_in(results, group, figure.name + "-panels")};
  figure.plot = plot_command(figure.name, group, sheet);
  return figure;
}

}  // namespace promenade::analysis
