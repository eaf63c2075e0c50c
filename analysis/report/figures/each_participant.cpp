#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "analysis/format.h"
#include "analysis/item.h"
#include "analysis/report/figures/kinds.h"
#include "analysis/report/figures/style.h"
#include "analysis/statistics/kernel_density.h"

namespace promenade::analysis {
namespace {

using Summaries = std::vector<const Summary*>;

// With more people lines hide everything, and a violin shows more than the dots.
constexpr int most_joined = 40;
constexpr int violin_points = 101;
constexpr double violin_width = 0.36;  // of a column, where a cloud is densest

double largest_value(const Summaries& summaries) {
  double largest = 0;
  for (const Summary* summary : summaries) {
    for (const auto& value : summary->values) largest = std::max(largest, value.value_or(0));
  }
  return largest;
}

// The limit or threshold of a task, where it would not squeeze the dots; nothing: none.
std::optional<double> reference(const Results& results, int task, const Measure& measure,
                                double largest) {
  const Task& one = item(results.data.tasks, task);
  const auto line = measure.name == "time_s" ? one.limit_s : one.threshold_m;
  return line && *line <= 1.5 * largest ? line : std::nullopt;
}

bool is_raincloud(const Results& results) { return size_of(results.data.people) > most_joined; }

std::string caption_of(const Results& results, int task, const Measure& measure,
                       const Summaries& summaries, const std::optional<double>& line) {
  std::string caption = fmt::format(
      "{}{}. Each dot is one participant (mean over targets), {}; squares are medians with 95 % "
      "intervals",
      capitalised(measure.label), in_task(results, task),
      is_raincloud(results)
          ? "moved aside within its column; clouds are densities by a Gaussian kernel, each as "
            "wide as the others where it is densest"
          : "grey lines join the same person");
  std::string counts;
  for (const Summary* summary : summaries) {
    counts += fmt::format("{}{} n = {}", counts.empty() ? "" : ", ",
                          item(results.data.interfaces, summary->interface), summary->n);
  }
  caption += "; " + counts + ".";
  if (line) {
    caption += fmt::format(" The dashed line is the {}, {}.",
                           measure.name == "time_s" ? "time limit" : "threshold",
                           with_unit(measure, *line));
  }
  return caption;
}

// 0 to 1, evenly spread over people, the same every time (multiples of the golden ratio).
double jitter_of(int person) { return std::fmod((person + 1) * 0.61803398874989485, 1.0); }

// A person's dots stand together, an empty line parts people.
Table people_data(const Results& results, const Summaries& summaries, const Measure& measure) {
  Table table{"", "", {"column", measure.name, "jitter", "participant", "interface"}, {}};
  for (int person = 0; person < size_of(results.data.people); ++person) {
    for (int i = 0; i < size_of(summaries); ++i) {
      const Summary& summary = *item(summaries, i);
      const auto& value = item(summary.values, person);
      if (!value) continue;
      table.rows.push_back({Cell(std::int64_t{i + 1}), Cell(*value), Cell(jitter_of(person)),
                            Cell(item(results.data.people, person)),
                            Cell(item(results.data.interfaces, summary.interface))});
    }
    table.rows.emplace_back();
  }
  return table;
}

Table median_data(const Results& results, const Summaries& summaries, const std::string& name) {
  Table table{name, "", {"column", "median", "lower", "upper", "n", "interface"}, {}};
  for (int i = 0; i < size_of(summaries); ++i) {
    const Summary& one = *item(summaries, i);
    const auto& ci = one.median_ci;
    table.rows.push_back({Cell(std::int64_t{i + 1}), Cell(*one.median),
                          ci ? Cell(ci->lower) : Cell(), ci ? Cell(ci->upper) : Cell(),
                          Cell(std::int64_t{one.n}),
                          Cell(item(results.data.interfaces, one.interface))});
  }
  return table;
}

// An empty line parts interfaces. Widths are shares of that of a column: every cloud is as wide
// as the others where it is densest, for one of people who all did nearly the same would make
// lines of the others.
Table violin_data(const Results& results, const Summaries& summaries, const Measure& measure,
                  const std::string& name) {
  Table table{name, "", {"column", measure.name, "width", "density", "bandwidth", "interface"}, {}};
  for (int i = 0; i < size_of(summaries); ++i) {
    std::vector<double> values;
    for (const auto& value : item(summaries, i)->values) {
      if (value) values.push_back(*value);
    }
    const auto cloud = kernel_density(values, violin_points);
    const double most = cloud ? *std::max_element(cloud->density.begin(), cloud->density.end()) : 1;
    for (std::size_t k = 0; cloud && k < cloud->at.size(); ++k) {
      table.rows.push_back({Cell(std::int64_t{i + 1}), Cell(cloud->at[k]),
                            Cell(violin_width * cloud->density[k] / most), Cell(cloud->density[k]),
                            Cell(cloud->bandwidth),
                            Cell(item(results.data.interfaces, item(summaries, i)->interface))});
    }
    table.rows.emplace_back();
  }
  return table;
}

// Cloud on the left, dots on the right, the median between them. Nothing is drawn of an interface
// without a cloud.
std::string raincloud_plot(const std::string& name, const Summaries& summaries, double scale,
                           double size) {
  std::string plot = "plot ";
  for (int i = 0; i < size_of(summaries); ++i) {
    plot += fmt::format(
        "'{0}-clouds.csv' using ($1=={2} ? $1-0.08-$3 : 1/0):($2*{1}) with filledcurves x={3} fs "
        "transparent solid 0.35 noborder lc rgb '#0072b2', \\\n  ",
        name, scale, i + 1, fixed(i + 1 - 0.08, 2));
  }
  return plot +
         fmt::format(
             "'{0}.csv' using ($1+0.1+0.3*$3):($2*{1}) with points pt 7 ps {2} lc rgb '#0072b2', "
             "\\\n"
             "  '{0}-medians.csv' using 1:($2*{1}):($3*{1}):($4*{1}) with yerrorbars pt 0 lw 2 lc "
             "rgb '#000000', \\\n"
             "  '{0}-medians.csv' using 1:($2*{1}) with points pt 5 ps 0.6 lc rgb '#000000'",
             name, scale, size);
}

constexpr const char* plot =
    "plot '{0}.csv' using 1:($2*{1}) with lines lc rgb '#bbbbbb' lw 0.8, \\\n"
    "  '{0}.csv' using 1:($2*{1}) with points pt 7 ps {2} lc rgb '#0072b2', \\\n"
    "  '{0}-medians.csv' using ($1+0.22):($2*{1}):($3*{1}):($4*{1}) with yerrorbars pt 0 "
    "lw 2 lc rgb '#000000', \\\n"
    "  '{0}-medians.csv' using ($1+0.22):($2*{1}) with points pt 5 ps 0.6 lc rgb '#000000'";

}  // namespace

std::optional<Figure> each_participant(const Results& results, int task, const std::string& name) {
  const int index = results.data.measure(name);
  const auto summaries = results.summaries_of(index, task);
  if (index < 0 || summaries.empty()) return std::nullopt;
  const Measure& measure = item(results.data.measures, index);
  const double largest = largest_value(summaries);
  const auto line = reference(results, task, measure, largest);
  Frame frame;
  frame.y_label = heading(measure);
  for (const Summary* summary : summaries) {
    frame.columns.push_back(item(results.data.interfaces, summary->interface));
  }
  const FramedPlot framing = framed(frame);
  Figure figure;
  figure.task = task;
  figure.name = figure_name(results, task, name);
  figure.title = capitalised(measure.label) + " of each participant";
  figure.caption = caption_of(results, task, measure, summaries, line);
  figure.width_mm = frame.width_mm;
  figure.height_mm = framing.height_mm;
  figure.data = {people_data(results, summaries, measure),
                 median_data(results, summaries, figure.name + "-medians")};
  const double top = std::max(largest, line.value_or(0)) * measure.scale;
  figure.setup = framing.commands + fmt::format("set yrange [0:{}]\n", top > 0 ? top * 1.06 : 1);
  if (line) {
    figure.setup += fmt::format(
        "set arrow from graph 0, first {0} to graph 1, first {0} nohead dt (6,4) lw 1 lc rgb "
        "'#444444'\n",
        *line * measure.scale);
  }
  const double size = results.data.people.size() > 60 ? 0.2 : 0.4;
  if (is_raincloud(results)) {
    figure.data.push_back(violin_data(results, summaries, measure, figure.name + "-clouds"));
    figure.plot = raincloud_plot(figure.name, summaries, measure.scale, size);
  } else {
    figure.plot = fmt::format(plot, figure.name, measure.scale, size);
  }
  return figure;
}

}  // namespace promenade::analysis
