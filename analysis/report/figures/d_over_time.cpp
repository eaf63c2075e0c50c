#include "analysis/d_over_time.h"

#include <fmt/format.h>

#include <algorithm>

#include "analysis/format.h"
#include "analysis/item.h"
#include "analysis/report/figures/kinds.h"
#include "analysis/report/figures/style.h"

namespace promenade::analysis {
namespace {

using Group = std::vector<const Curve*>;

constexpr int most_bands = 3;  // more only hide each other

double largest_of(const std::vector<double>& values) {
  return *std::max_element(values.begin(), values.end());
}

// Curves of one interface stand together, an empty line parts them.
Table data_of(const Results& results, const Group& curves) {
  Table table{"",
              "",
              {"time_s", "series", "lower_quartile_m", "median_m", "upper_quartile_m", "trials",
               "interface"},
              {}};
  for (int k = 0; k < size_of(curves); ++k) {
    const Curve& one = *item(curves, k);
    for (std::size_t i = 0; i < one.times_s.size(); ++i) {
      table.rows.push_back({Cell(one.times_s[i]), Cell(std::int64_t{k}),
                            Cell(one.lower_quartile[i]), Cell(one.median[i]),
                            Cell(one.upper_quartile[i]), Cell(std::int64_t{one.trials}),
                            Cell(item(results.data.interfaces, one.interface))});
    }
    table.rows.emplace_back();
  }
  return table;
}

std::string caption_of(const Results& results, int task, const Group& group, const Curves& curves) {
  std::string counts;
  for (const Curve* one : group) {
    counts += fmt::format("{}{} {}", counts.empty() ? "" : ", ",
                          item(results.data.interfaces, one->interface), one->trials);
  }
  std::string caption = fmt::format(
      "D while the trials went on{}: median {}over all trials, which keep their last D when they "
      "have ended. Trials: {}.",
      in_task(results, task), size_of(group) <= most_bands ? "(line) and quartiles (band) " : "",
      counts);
  if (curves.paused > 0) {
    caption += " " + capitalised(count_of(curves.paused, "trial that was", "trials that were")) +
               " paused or interrupted stay out of it.";
  }
  return caption;
}

std::string plot_command(const std::string& name, const Group& group) {
  std::string plot;
  const auto look = [&](int k) { return item(group, k)->interface; };
  const auto add = [&](int k, const std::string& how) {
    plot += fmt::format("{}'{}.csv' using ($2=={} ? $1 : 1/0):{}",
                        plot.empty() ? "plot " : ", \\\n  ", name, k, how);
  };
  for (int k = 0; k < size_of(group) && size_of(group) <= most_bands; ++k) {
    add(k, "($3*100):($5*100) with filledcurves " + fill_style(look(k)));
  }
  for (int k = 0; k < size_of(group); ++k) add(k, "($4*100) with lines " + line_style(look(k)));
  return plot;
}

}  // namespace

std::optional<Figure> d_over_time(const Results& results, int task, const Curves& curves) {
  Group group;
  double end = 0;
  double top = 0;
  double high = 0;
  for (const Curve& one : curves.curves) {
    if (one.task != task) continue;
    group.push_back(&one);
    end = std::max(end, one.times_s.back());
    top = std::max(top, largest_of(one.median));
    high = std::max(high, largest_of(one.upper_quartile));
  }
  if (group.empty() || item(results.data.tasks, task).guess || !(end > 0)) return std::nullopt;
  if (size_of(group) <= most_bands) top = high;
  Frame frame;
  frame.x_label = "Time since the trial began (s)";
  frame.y_label = "D (cm)";
  frame.lines = true;
  for (const Curve* one : group) {
    frame.series.push_back(item(results.data.interfaces, one->interface));
    frame.looks.push_back(one->interface);
  }
  const FramedPlot framing = framed(frame);
  Figure figure;
  figure.task = task;
  figure.name = figure_name(results, task, "d_over_time");
  figure.title = "D over time";
  figure.caption = caption_of(results, task, group, curves);
  figure.width_mm = frame.width_mm;
  figure.height_mm = framing.height_mm;
  figure.data = {data_of(results, group)};
  figure.setup = framing.commands + fmt::format("set xrange [0:{}]\nset yrange [0:{}]\n", end,
                                                top > 0 ? top * 106 : 1);
  if (const auto line = item(results.data.tasks, task).threshold_m) {
    figure.caption +=
        fmt::format(" The dashed grey line is the threshold, {} cm.", fixed(*line * 100, 1));
    figure.setup += fmt::format(
        "set arrow from graph 0, first {0} to graph 1, first {0} nohead dt (6,4) lw 1 lc rgb "
        "'#444444'\n",
        *line * 100);
  }
  figure.plot = plot_command(figure.name, group);
  return figure;
}

}  // namespace promenade::analysis
