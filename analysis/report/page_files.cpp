// Figures, and the files beside the page.
#include <fmt/format.h>

#include "analysis/format.h"
#include "analysis/item.h"
#include "analysis/report/page_parts.h"
#include "analysis/report/tables.h"

namespace promenade::analysis {
namespace {

Html link(const std::string& address, const std::string& label) {
  return element("a", {{"href", address}}, text(label));
}

Html files_of(const Figure& figure) {
  const std::string base = "figures/" + figure.name;
  Html links = link(base + ".pdf", "PDF") + text(", ") + link(base + ".svg", "SVG") + text(", ") +
               link(base + ".gp", "script");
  for (const Table& table : figure.data) {
    const std::string name = table.name.empty() ? figure.name : table.name;
    links += text(", ") + link("figures/" + name + ".csv", "data");
  }
  return element("span", {{"class", "files"}}, links);
}

// The picture is described by its caption; who cannot see it is led to its numbers.
Html figure_on_page(const DrawnFigure& drawn, int number) {
  const Figure& figure = drawn.figure;
  const std::string source = "data:image/svg+xml;base64," + base64(drawn.svg);
  const std::string alt =
      fmt::format("Plot: {}. Its numbers are in figures/{}.csv.", figure.title, figure.name);
  const bool wide = figure.width_mm > 100;
  const Html caption = element("b", fmt::format("Figure {}. {}.", number, figure.title)) +
                       text(" " + figure.caption + " ") + files_of(figure);
  return element("figure", {{"class", wide ? "full" : "column"}},
                 empty_element("img", {{"src", source}, {"alt", alt}}) +
                     element("figcaption", caption)) +
         trusted("\n");
}

Html item_of(const std::string& file, const std::string& what) {
  return element("li", link(file, file) + text(": " + what)) + trusted("\n");
}

}  // namespace

Html figure_section(const Results& results, const std::vector<DrawnFigure>& figures) {
  Html html = element("h2", {{"id", "figures"}}, text("Figures"));
  if (!results.map_times.missing.empty()) html += element("p", results.map_times.missing);
  int number = 0;
  const auto add = [&](int task, const std::string& heading) {
    Html pictures;
    for (const DrawnFigure& drawn : figures) {
      if (drawn.figure.task == task) pictures += figure_on_page(drawn, ++number);
    }
    if (pictures.code.empty()) return;
    if (!heading.empty()) html += element("h3", heading);
    html += element("div", {{"class", "figures"}}, pictures);
  };
  const int tasks = size_of(results.data.tasks);
  for (int task = 0; task < tasks; ++task) {
    add(task, tasks > 1 ? "Task " + item(results.data.tasks, task).name : "");
  }
  add(-1, "The motions");
  return html;
}

Html file_section(const Results& results, const std::vector<Section>& sections) {
  Html list = item_of("report.json", "every number of this page.");
  for (const Table& one : all_tables(results, sections)) {
    list += item_of("tables/" + one.name + ".csv",
                    one.caption + " " + count_of(size_of(one.rows), "row.", "rows."));
  }
  return element("h2", {{"id", "data"}}, text("Data")) +
         element("p", "Files beside this page; numbers with full precision, metres and seconds.") +
         element("ul", {{"class", "data"}}, list);
}

}  // namespace promenade::analysis
