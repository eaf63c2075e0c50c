#include <fmt/format.h>

#include <algorithm>

#include "analysis/format.h"
#include "analysis/item.h"
#include "analysis/report/figures/kinds.h"
#include "analysis/report/figures/style.h"
#include "analysis/report/gnuplot.h"
#include "analysis/statistics/kaplan_meier.h"

namespace promenade::analysis {
namespace {

constexpr double risk_row_mm = 3.4;

struct Group {
  int interface = 0;
  std::vector<Duration> durations;
  int done = 0;
};

std::vector<Group> groups_of(const Results& results, int task) {
  const int time = results.data.measure("time_s");
  std::vector<Group> groups;
  for (const int i : interfaces_in(results, task)) {
    Group group;
    group.interface = i;
    for (const Trial& trial : results.data.trials) {
      if (trial.task != task || trial.interface != i || !item(trial.values, time)) continue;
      group.durations.push_back({*item(trial.values, time), !trial.failed});
      group.done += trial.failed ? 0 : 1;
    }
    if (!group.durations.empty()) groups.push_back(std::move(group));
  }
  return groups;
}

// Steps of each curve from (0, 1); an empty line parts the curves.
Table data_of(const Results& results, const std::vector<Group>& groups) {
  Table table{
      "", "", {"time_s", "series", "not_done", "at_risk", "done", "stopped", "interface"}, {}};
  for (int k = 0; k < size_of(groups); ++k) {
    const Group& group = item(groups, k);
    const Cell name(item(results.data.interfaces, group.interface));
    const Cell series(std::int64_t{k});
    table.rows.push_back({Cell(0.0), series, Cell(1.0),
                          Cell(std::int64_t{size_of(group.durations)}), Cell(std::int64_t{0}),
                          Cell(std::int64_t{0}), name});
    for (const SurvivalStep& step : kaplan_meier(group.durations).steps) {
      table.rows.push_back({Cell(step.time), series, Cell(step.survival),
                            Cell(std::int64_t{step.at_risk}), Cell(std::int64_t{step.done}),
                            Cell(std::int64_t{step.censored}), name});
    }
    table.rows.emplace_back();
  }
  return table;
}

double longest(const std::vector<Group>& groups) {
  double end = 0;
  for (const Group& group : groups) {
    for (const Duration& one : group.durations) end = std::max(end, one.time);
  }
  return end;
}

// How many trials are still going at each tick, in rows under the axis.
std::string risk_rows(const Results& results, const std::vector<Group>& groups, const Frame& frame,
                      double height_mm, double end, double step) {
  const double plot_mm = frame.width_mm - frame.left_mm - 3;
  std::string labels;
  const auto put = [&](const std::string& text, double x_mm, double y_mm, const char* side) {
    labels += fmt::format("set label {} at screen {:.4f},{:.4f} {}\n", gnuplot_text(text),
                          x_mm / frame.width_mm, y_mm / height_mm, side);
  };
  put("Still at it", 1.5, frame.below_mm - 1.2, "left");
  for (int k = 0; k < size_of(groups); ++k) {
    const Group& group = item(groups, k);
    const double y = frame.below_mm - 1.2 - risk_row_mm * (k + 1);
    put(fitted_mm(item(results.data.interfaces, group.interface), frame.left_mm - 4), 1.5, y,
        "left");
    for (int tick = 0; tick * step <= end * (1 + 1e-9); ++tick) {
      const auto at_risk =
          std::count_if(group.durations.begin(), group.durations.end(),
                        [&](const Duration& one) { return one.time >= tick * step; });
      put(std::to_string(at_risk), frame.left_mm + plot_mm * tick * step / end, y, "center");
    }
  }
  return labels;
}

std::string plot_command(const std::string& name, const std::vector<int>& looks) {
  std::string plot;
  for (int k = 0; k < size_of(looks); ++k) {
    plot += fmt::format("{0}'{1}.csv' using ($2=={2} ? $1 : 1/0):($3*100) with steps {3}",
                        k == 0 ? "plot " : ", \\\n  ", name, k, line_style(item(looks, k)));
  }
  for (int k = 0; k < size_of(looks); ++k) {
    const std::string style = line_style(item(looks, k));
    plot += fmt::format(
        ", \\\n  '{0}.csv' using ($2=={1} && $6>0 ? $1 : 1/0):($3*100) with points pt 1 ps 0.5 {2}",
        name, k, style.substr(style.find("lw")));
  }
  return plot;
}

std::string caption_of(const Results& results, int task, const std::vector<Group>& groups) {
  std::string counts;
  for (const Group& group : groups) {
    counts += fmt::format("{}{} {} of {}", counts.empty() ? "" : ", ",
                          item(results.data.interfaces, group.interface), group.done,
                          group.durations.size());
  }
  return fmt::format(
      "Share of trials that were not yet done{} (Kaplan-Meier); a cross is where trials stopped "
      "without success, at the limit or given up. Below, how many were still at it. Done: {}. "
      "Trials of one person are not independent; the curves describe, they do not test.",
      in_task(results, task), counts);
}

}  // namespace

std::optional<Figure> survival_curves(const Results& results, int task) {
  const std::vector<Group> groups = groups_of(results, task);
  const double end = longest(groups);
  if (item(results.data.tasks, task).guess || !(end > 0)) return std::nullopt;
  Frame frame;
  frame.x_label = "Time (s)";
  frame.y_label = "Not yet done (%)";
  frame.lines = true;
  frame.below_mm = risk_row_mm * (size_of(groups) + 1) + 0.5;
  double widest = 0;
  for (const Group& group : groups) {
    frame.series.push_back(item(results.data.interfaces, group.interface));
    frame.looks.push_back(group.interface);
    widest = std::max(widest, text_mm(frame.series.back()));
  }
  frame.left_mm = std::clamp(widest + 5, 14.0, 28.0);
  const FramedPlot framing = framed(frame);
  const double step = round_step(end);
  Figure figure;
  figure.task = task;
  figure.name = figure_name(results, task, "survival");
  figure.title = "Time until done";
  figure.caption = caption_of(results, task, groups);
  figure.width_mm = frame.width_mm;
  figure.height_mm = framing.height_mm;
  figure.data = {data_of(results, groups)};
  figure.setup = framing.commands +
                 fmt::format("set xrange [0:{}]\nset xtics {}\nset yrange [0:104]\n", end, step) +
                 risk_rows(results, groups, frame, framing.height_mm, end, step);
  figure.plot = plot_command(figure.name, frame.looks);
  return figure;
}

}  // namespace promenade::analysis
