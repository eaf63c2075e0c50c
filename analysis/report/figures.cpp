#include "analysis/report/figures.h"

#include <fmt/format.h>

#include "analysis/item.h"
#include "analysis/parallel.h"
#include "analysis/report/figures/kinds.h"
#include "analysis/report/gnuplot.h"
#include "motion/files.h"

namespace promenade::analysis {
namespace {

namespace fs = std::filesystem;

constexpr double point_mm = 25.4 / 72;

std::string file_name(const Figure& figure, const Table& table) {
  return (table.name.empty() ? figure.name : table.name) + ".csv";
}

// gnuplot reads line by line, so a name must not go over two.
Table in_lines(Table table) {
  for (std::vector<Cell>& row : table.rows) {
    for (Cell& cell : row) {
      auto* text = std::get_if<std::string>(&cell);
      if (!text) continue;
      for (char& letter : *text) letter = static_cast<unsigned char>(letter) < 0x20 ? ' ' : letter;
    }
  }
  return table;
}

void write_source(const Figure& figure, const fs::path& folder) {
  for (const Table& table : figure.data) {
    write_file(folder / file_name(figure, table), to_csv(in_lines(table)));
  }
  write_file(folder / (figure.name + ".gp"), script_of(figure));
}

nlohmann::json json_of(const Cell& cell) {
  if (const auto* text = std::get_if<std::string>(&cell)) return *text;
  if (const auto* count = std::get_if<std::int64_t>(&cell)) return *count;
  if (const auto* number = std::get_if<double>(&cell)) return *number;
  return nullptr;
}

nlohmann::json json_of(const Figure& figure, const Table& table) {
  nlohmann::json rows = nlohmann::json::array();
  for (const std::vector<Cell>& row : table.rows) {
    if (row.empty()) continue;
    nlohmann::json cells = nlohmann::json::array();
    for (const Cell& cell : row) cells.push_back(json_of(cell));
    rows.push_back(std::move(cells));
  }
  return {{"file", file_name(figure, table)}, {"columns", table.columns}, {"rows", rows}};
}

}  // namespace

std::vector<Figure> figures_of(const Results& results) {
  std::vector<Figure> figures;
  const auto add = [&](std::optional<Figure> figure) {
    if (figure) figures.push_back(std::move(*figure));
  };
  const Curves curves = curves_of(results);
  for (int task = 0; task < size_of(results.data.tasks); ++task) {
    for (const char* measure : {"d_final", "asked_quality", "time_s"}) {
      if (results.data.measure(measure) < 0) continue;
      add(each_participant(results, task, measure));
      add(forest(results, task, measure));
      add(means_by_target(results, task, measure));
      add(differences_to_reference(results, task, measure));
    }
    add(success_by_target(results, task));
    add(failures_by_target(results, task));
    add(survival_curves(results, task));
    add(d_over_time(results, task, curves));
    add(map_heat(results, task));
  }
  add(dendrogram(results));
  add(dendrogram_of_pairs(results));
  put_printed_first(results, figures);
  return figures;
}

// gnuplot's cairo takes the point of a font for 1/54 inch, hence 0.75; and its line of width 1 is
// half as thick as that of SVG, where one unit is a point here.
std::string script_of(const Figure& figure) {
  return fmt::format(
      "# {0}\n# gnuplot {0}.gp writes {0}.svg and {0}.pdf again.\nreset\nset encoding utf8\n"
      "set datafile separator comma columnheaders commentschars ''\n"
      "set minussign\nset key off\nset border 3 lw 0.8 lc rgb '#444444'\nset tics out scale 0.5\n"
      "set ytics nomirror\nset grid ytics lc rgb '#dddddd' lw 0.6 dt 1\n{1}"
      "set terminal svg size {2:.0f},{3:.0f} font 'Noto Sans,8' noenhanced linewidth 0.5 "
      "background '#ffffff'\n"
      "set output '{0}.svg'\n{6}\n"
      "set terminal pdfcairo size {4:.3f}cm,{5:.3f}cm font 'Noto Sans,8' fontscale 0.75 noenhanced "
      "linewidth 1.4\n"
      "set output '{0}.pdf'\nreplot\nset output\n",
      figure.name, figure.setup, figure.width_mm / point_mm, figure.height_mm / point_mm,
      figure.width_mm / 10, figure.height_mm / 10, figure.plot);
}

std::vector<DrawnFigure> draw(const std::vector<Figure>& figures, const fs::path& folder,
                              const Progress& progress) {
  std::vector<DrawnFigure> drawn(figures.size());
  for (const Figure& figure : figures) write_source(figure, folder);
  // A gnuplot for each: its SVG depends on what the same process has drawn before.
  const auto work = [&](int index) {
    const Figure& figure = item(figures, index);
    run_gnuplot_file(figure.name + ".gp", folder);
    const fs::path pdf = folder / (figure.name + ".pdf");
    write_file(pdf, without_creation_date(read_file(pdf)));
    item(drawn, index) = {figure, read_file(folder / (figure.name + ".svg"))};
  };
  report_progress(progress, "figures drawn:", 0, size_of(figures));
  for_each_index(size_of(figures), work, progress, "figures drawn:");
  return drawn;
}

Section figure_numbers(const std::vector<Figure>& figures) {
  Section section;
  nlohmann::json& list = section.json["figures"] = nlohmann::json::array();
  for (const Figure& figure : figures) {
    nlohmann::json data = nlohmann::json::array();
    for (const Table& table : figure.data) data.push_back(json_of(figure, table));
    list.push_back({{"name", figure.name},
                    {"title", figure.title},
                    {"caption", figure.caption},
                    {"data", std::move(data)}});
  }
  return section;
}

}  // namespace promenade::analysis
