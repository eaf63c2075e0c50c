#include <fmt/format.h>

#include <algorithm>

#include "analysis/format.h"
#include "analysis/item.h"
#include "analysis/report/figures/kinds.h"
#include "analysis/report/figures/style.h"
#include "analysis/report/gnuplot.h"
#include "analysis/report/sentences.h"

namespace promenade::analysis {
namespace {

using Pairs = std::vector<const Comparison*>;

constexpr double row_mm = 5;

std::string pair_name(const Results& results, const Comparison& one) {
  return item(results.data.interfaces, one.a) + " − " + item(results.data.interfaces, one.b);
}

// Each of the two names gets half of the room.
std::string short_pair_name(const Results& results, const Comparison& one, double room_mm) {
  if (text_mm(pair_name(results, one)) <= room_mm) return pair_name(results, one);
  const double half = (room_mm - text_mm(" − ")) / 2;
  return fitted_mm(item(results.data.interfaces, one.a), half) + " − " +
         fitted_mm(item(results.data.interfaces, one.b), half);
}

// The first pair stands at the top.
Table data_of(const Results& results, const Pairs& pairs) {
  Table table{"", "", {"row", "hl", "lower", "upper", "n", "significant", "pair"}, {}};
  for (int i = 0; i < size_of(pairs); ++i) {
    const Comparison& one = *item(pairs, i);
    const auto& ci = one.hl_ci;
    table.rows.push_back({Cell(std::int64_t{size_of(pairs) - i}), Cell(*one.hl),
                          ci ? Cell(ci->interval.lower) : Cell(),
                          ci ? Cell(ci->interval.upper) : Cell(), Cell(std::int64_t{one.test.n}),
                          Cell(std::int64_t{is_significant(one) ? 1 : 0}),
                          Cell(pair_name(results, one))});
  }
  return table;
}

std::string ranges(const Pairs& pairs, double scale) {
  double low = 0;
  double high = 0;
  for (const Comparison* one : pairs) {
    const Interval ci = one->hl_ci ? one->hl_ci->interval : Interval{*one->hl, *one->hl};
    low = std::min(low, ci.lower * scale);
    high = std::max(high, ci.upper * scale);
  }
  if (!(high > low)) high = low + 1;
  const double more = 0.06 * (high - low);
  return fmt::format("set xrange [{}:{}]\nset xtics {}\nset yrange [0.4:{}.6]\n", low - more,
                     high + more, round_step(high - low), pairs.size());
}

std::string row_names(const Results& results, const Pairs& pairs, double room_mm) {
  std::string tics;
  for (int i = 0; i < size_of(pairs); ++i) {
    tics += fmt::format("{}{} {}", i > 0 ? ", " : "",
                        gnuplot_text(short_pair_name(results, *item(pairs, i), room_mm)),
                        size_of(pairs) - i);
  }
  return "set ytics (" + tics + ") scale 0\n";
}

std::string caption_of(const Results& results, int task, const Measure& measure,
                       const Pairs& pairs) {
  const auto by_n = [](auto* a, auto* b) { return a->test.n < b->test.n; };
  const auto [least, most] = std::minmax_element(pairs.begin(), pairs.end(), by_n);
  const int n = (*most)->test.n;
  const bool same = (*least)->test.n == n;
  return fmt::format(
      "Differences of {}{} between interfaces, one value per participant (mean over targets): "
      "Hodges-Lehmann estimate with 95 % interval, n = {}. Filled: p < .05{}.",
      measure.label, in_task(results, task),
      same ? std::to_string(n) : fmt::format("{} to {}", (*least)->test.n, n),
      pairs[0]->family > 1 ? fmt::format(" after Holm's adjustment over {} pairs", pairs[0]->family)
                           : "");
}

constexpr const char* plot =
    "plot '{0}.csv' using ($2*{1}):1:($3*{1}):($4*{1}) with xerrorbars pt 0 lw 1.5 "
    "lc rgb '#000000', \\\n"
    "  '{0}.csv' using ($6==1 ? $2*{1} : 1/0):1 with points pt 5 ps 0.6 lc rgb '#0072b2', \\\n"
    "  '{0}.csv' using ($6==1 ? 1/0 : $2*{1}):1 with points pt 4 ps 0.6 lw 1.2 lc rgb '#555555'";

}  // namespace

std::optional<Figure> forest(const Results& results, int task, const std::string& name) {
  const int index = results.data.measure(name);
  Pairs pairs = index < 0 ? Pairs{} : results.pairs(index, task);
  pairs.erase(std::remove_if(pairs.begin(), pairs.end(), [](auto* one) { return !one->hl; }),
              pairs.end());
  if (pairs.empty()) return std::nullopt;
  const Measure& measure = item(results.data.measures, index);
  double widest = 0;
  for (const Comparison* one : pairs) widest = std::max(widest, text_mm(pair_name(results, *one)));
  Frame frame;
  frame.left_mm = std::clamp(widest + 4, 16.0, 40.0);
  frame.plot_mm = row_mm * static_cast<double>(pairs.size() + 1);
  frame.x_label =
      "Difference" + (measure.shown_unit.empty() ? "" : " (" + measure.shown_unit + ")");
  const FramedPlot framing = framed(frame);
  Figure figure;
  figure.task = task;
  figure.name = figure_name(results, task, name + "_pairs");
  figure.title = capitalised(measure.label) + ": all pairs of interfaces";
  figure.caption = caption_of(results, task, measure, pairs);
  figure.width_mm = frame.width_mm;
  figure.height_mm = framing.height_mm;
  figure.data = {data_of(results, pairs)};
  figure.setup = framing.commands + ranges(pairs, measure.scale) +
                 row_names(results, pairs, frame.left_mm - 4) +
                 "set grid xtics noytics lc rgb '#dddddd' lw 0.6 dt 1\n"
                 "set arrow from 0, graph 0 to 0, graph 1 nohead dt (6,4) lw 1 lc rgb '#444444'\n";
  figure.plot = fmt::format(plot, figure.name, measure.scale);
  return figure;
}

}  // namespace promenade::analysis
