// Points with bars, one series per interface, side by side for each target: what [O] plots in its
// Figures 7 to 11.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "analysis/format.h"
#include "analysis/item.h"
#include "analysis/report/figures/kinds.h"
#include "analysis/report/figures/style.h"
#include "analysis/target_means.h"

namespace promenade::analysis {
namespace {

struct Mark {
  int interface = 0;
  int target = -1;  // -1: all
  int n = 0;
  double value = 0;
  std::optional<Interval> bar;
};

struct Chart {
  std::string name, title, caption, value_name;
  Frame frame;
  double scale = 1;
  bool from_zero = false;  // bars that reach below are cut off
  std::optional<double> most;
  std::optional<double> line;  // across the plot
};

// Targets are 1, 2, ...; all of them together come last.
int column_of(const Results& results, int task, int target) {
  return target >= 0 ? target + 1 : size_of(item(results.data.tasks, task).targets) + 1;
}

Table data_of(const Results& results, int task, const std::vector<Mark>& marks,
              const std::string& value_name) {
  Table table{
      "", "", {"column", "series", value_name, "lower", "upper", "n", "target", "interface"}, {}};
  const auto& targets = item(results.data.tasks, task).targets;
  for (const Mark& mark : marks) {
    const auto bar = mark.bar;
    table.rows.push_back({Cell(std::int64_t{column_of(results, task, mark.target)}),
                          Cell(std::int64_t{mark.interface}), Cell(mark.value),
                          bar ? Cell(bar->lower) : Cell(), bar ? Cell(bar->upper) : Cell(),
                          Cell(std::int64_t{mark.n}),
                          mark.target < 0 ? Cell("all") : Cell(item(targets, mark.target)),
                          Cell(item(results.data.interfaces, mark.interface))});
  }
  return table;
}

std::string y_range(const Chart& chart, const std::vector<Mark>& marks) {
  double low = 0;
  double high = chart.most.value_or(chart.line.value_or(0) * chart.scale);
  for (const Mark& mark : marks) {
    const Interval bar = mark.bar.value_or(Interval{mark.value, mark.value});
    low = std::min({low, bar.lower * chart.scale, mark.value * chart.scale});
    high = std::max({high, bar.upper * chart.scale, mark.value * chart.scale});
  }
  if (chart.from_zero) low = 0;
  if (!(high > low)) high = low + 1;
  const double more = 0.05 * (high - low);
  return fmt::format("set yrange [{}:{}]\n", low < 0 ? low - more : low, high + more);
}

std::string plot_command(const Chart& chart, const std::vector<int>& interfaces) {
  const auto count = static_cast<double>(interfaces.size());
  const double step = std::min(0.16, 0.72 / count);
  std::string plot;
  for (std::size_t k = 0; k < interfaces.size(); ++k) {
    const double shift = step * (static_cast<double>(k) - (count - 1) / 2);
    plot += fmt::format(
        "{0}'{1}.csv' using ($1+{2:.3f}):($2=={3} ? $3*{4} : 1/0):($4*{4}):($5*{4}) "
        "with yerrorbars {5}, \\\n  "
        "'{1}.csv' using ($1+{2:.3f}):($2=={3} ? $3*{4} : 1/0) with points {6}",
        k == 0 ? "plot " : ", \\\n  ", chart.name, shift, interfaces[k], chart.scale,
        bar_style(interfaces[k]), point_style(interfaces[k]));
  }
  return plot;
}

Figure figure_of(const Results& results, int task, Chart chart, const std::vector<Mark>& marks) {
  std::vector<int> interfaces;
  for (const int i : interfaces_in(results, task)) {
    const auto is_i = [&](const Mark& mark) { return mark.interface == i; };
    if (std::any_of(marks.begin(), marks.end(), is_i)) interfaces.push_back(i);
  }
  const auto& targets = item(results.data.tasks, task).targets;
  chart.frame.columns = targets;
  if (targets.size() > 1) chart.frame.columns.emplace_back("all");
  chart.frame.series = names_of(results, interfaces);
  chart.frame.looks = interfaces;
  if (chart.frame.columns.size() * interfaces.size() > 12) chart.frame.width_mm = two_columns_mm;
  const FramedPlot plot = framed(chart.frame);
  Figure figure{task,
                chart.name,
                chart.title,
                chart.caption,
                chart.frame.width_mm,
                plot.height_mm,
                {data_of(results, task, marks, chart.value_name)},
                plot.commands,
                ""};
  figure.setup += y_range(chart, marks);
  if (targets.size() > 1) {
    figure.setup += fmt::format(
        "set arrow from {0}.5, graph 0 to {0}.5, graph 1 nohead lw 0.6 lc rgb '#999999'\n",
        targets.size());
  }
  if (chart.line) {
    figure.setup += fmt::format(
        "set arrow from graph 0, first {0} to graph 1, first {0} nohead dt (6,4) lw 1 lc rgb "
        "'#444444'\n",
        *chart.line * chart.scale);
  }
  figure.plot = plot_command(chart, interfaces);
  return figure;
}

// "n = 12 to 13"
std::string people(const std::vector<Mark>& marks) {
  const auto by_n = [](const Mark& a, const Mark& b) { return a.n < b.n; };
  const auto [least, most] = std::minmax_element(marks.begin(), marks.end(), by_n);
  if (least->n == most->n) return fmt::format("n = {}", most->n);
  return fmt::format("n = {} to {}", least->n, most->n);
}

std::optional<double> threshold_line(const Results& results, int task, const Measure& measure,
                                     double largest) {
  const auto line = item(results.data.tasks, task).threshold_m;
  return measure.name == "d_final" && line && *line < 1.5 * largest ? line : std::nullopt;
}

// Where a trial either fails or does not: each target, then all where there are several.
std::vector<Mark> share_marks(const Results& results, int task, bool failures) {
  const bool several = item(results.data.tasks, task).targets.size() > 1;
  std::vector<Mark> marks, all;
  for (const FailureRatio& one : results.failures) {
    if (one.task != task) continue;
    const double share = static_cast<double>(one.failed) / one.trials;
    const Interval& bar = one.wilson;
    Mark mark{one.interface, one.target, one.trials, share, bar};
    if (!failures) {
      mark.value = 1 - share;
      mark.bar = Interval{1 - bar.upper, 1 - bar.lower};
    }
    if (one.target >= 0) marks.push_back(mark);
    if (one.target < 0 && several) all.push_back(mark);
  }
  marks.insert(marks.end(), all.begin(), all.end());
  return marks;
}

std::optional<Figure> shares(const Results& results, int task, bool failures) {
  const std::vector<Mark> marks = share_marks(results, task, failures);
  if (marks.empty()) return std::nullopt;
  Chart chart;
  chart.name = figure_name(results, task, failures ? "failures" : "guessed");
  chart.title = failures ? "Failures per target" : "Targets met by the guess alone";
  chart.caption = fmt::format(
      "{}{}, with 95 % intervals of Wilson; {} trials each. Trials of one person are not "
      "independent, so the intervals of all targets together are too narrow.",
      failures ? "Share of trials that failed (at the limit, or done above the threshold)"
               : "Share of guesses with D below the threshold",
      in_task(results, task), people(marks));
  chart.value_name = "share";
  chart.frame.y_label = failures ? "Failed (%)" : "Met (%)";
  chart.scale = 100;
  chart.most = 100;
  return figure_of(results, task, chart, marks);
}

}  // namespace

std::optional<Figure> means_by_target(const Results& results, int task, const std::string& name) {
  const int index = results.data.measure(name);
  if (index < 0) return std::nullopt;
  const Measure& measure = item(results.data.measures, index);
  std::vector<Mark> marks;
  double largest = 0;
  for (const TargetMean& one : target_means(results.data, index, task)) {
    std::optional<Interval> bar;
    if (one.sd) bar = {one.mean - *one.sd, one.mean + *one.sd};
    marks.push_back({one.interface, one.target, one.n, one.mean, bar});
    largest = std::max(largest, bar ? bar->upper : one.mean);
  }
  if (marks.empty()) return std::nullopt;
  const bool guess = item(results.data.tasks, task).guess && name == "d_final";
  Chart chart;
  chart.name = figure_name(results, task, name + "_by_target");
  const std::string what = guess ? "D of the guess" : capitalised(measure.label);
  chart.title = "Mean " + (guess ? what : measure.label) + " per target";
  chart.line = threshold_line(results, task, measure, largest);
  chart.caption =
      fmt::format("Mean {}{} over participants; bars are one standard deviation to each side; {}.",
                  guess ? what : measure.label, in_task(results, task), people(marks));
  if (chart.line)
    chart.caption += " The dashed line is the threshold, " + with_unit(measure, *chart.line) + ".";
  chart.value_name = "mean_" + (measure.unit.empty() ? "count" : measure.unit);
  chart.frame.y_label = heading(measure);
  chart.from_zero = true;
  chart.scale = measure.scale;
  return figure_of(results, task, chart, marks);
}

std::optional<Figure> differences_to_reference(const Results& results, int task,
                                               const std::string& name) {
  const int index = results.data.measure(name);
  const int reference = reference_interface(results.data, task);
  if (index < 0 || reference < 0) return std::nullopt;
  const Measure& measure = item(results.data.measures, index);
  std::vector<Mark> marks;
  for (const MeanDifference& one : mean_differences(results.data, index, task, reference)) {
    marks.push_back({one.interface, one.target, one.n, one.mean, one.interval});
  }
  if (marks.empty()) return std::nullopt;
  const std::string base = item(results.data.interfaces, reference);
  Chart chart;
  chart.name = figure_name(results, task, name + "_to_reference");
  chart.title = capitalised(measure.label) + " compared with " + base;
  chart.caption = fmt::format(
      "Mean difference of {}{}: each interface minus {}, with the 90 % interval of that mean "
      "(Student's t); {} participants.",
      measure.label, in_task(results, task), base, people(marks));
  chart.value_name = "difference_" + (measure.unit.empty() ? "count" : measure.unit);
  chart.frame.y_label =
      "Difference" + (measure.shown_unit.empty() ? "" : " (" + measure.shown_unit + ")");
  chart.scale = measure.scale;
  chart.line = 0;
  return figure_of(results, task, chart, marks);
}

std::optional<Figure> success_by_target(const Results& results, int task) {
  const Task& one = item(results.data.tasks, task);
  return one.guess && one.threshold_m ? shares(results, task, false) : std::nullopt;
}

std::optional<Figure> failures_by_target(const Results& results, int task) {
  const Task& one = item(results.data.tasks, task);
  const bool can_fail = one.limit_s || one.threshold_m;
  return can_fail && !one.guess ? shares(results, task, true) : std::nullopt;
}

}  // namespace promenade::analysis
