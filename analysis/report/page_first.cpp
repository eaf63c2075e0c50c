// The first page: a sentence, the flow of participants, dots and pairs.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "analysis/format.h"
#include "analysis/item.h"
#include "analysis/report/page_parts.h"
#include "analysis/report/sentences.h"
#include "analysis/report/tables.h"

namespace promenade::analysis {
namespace {

constexpr double strip_width = 560;  // pixels of the drawing
constexpr double strip_height = 62;
constexpr double dot_row = 24;  // where dots lie and
constexpr double bar_row = 49;  // where the median lies
constexpr double dot_radius = 4;
constexpr double margin = 12;

// Values to pixels, from 0 to a round number, with round ticks.
struct Axis {
  double last = 1;
  double step = 1;
  double x(double value) const { return margin + value / last * (strip_width - 2 * margin); }
};

Axis axis_up_to(double largest) {
  if (!(largest > 0)) return {1, 1};
  const double rough = largest / 5;
  const double power = std::pow(10, std::floor(std::log10(rough)));
  Axis axis;
  for (const double factor : {1.0, 2.0, 5.0, 10.0}) {
    axis.step = factor * power;
    if (axis.step >= rough) break;
  }
  axis.last = axis.step * std::ceil(largest / axis.step);
  return axis;
}

std::string px(double value) { return fmt::format("{:.1f}", value); }

Html line(double x1, double y1, double x2, double y2, const char* colour, const char* width) {
  return empty_element("line", {{"x1", px(x1)},
                                {"y1", px(y1)},
                                {"x2", px(x2)},
                                {"y2", px(y2)},
                                {"stroke", colour},
                                {"stroke-width", width}});
}

// Dots that would lie on each other move apart, up and down in turn.
Html dots(const std::vector<std::optional<double>>& values, const Axis& axis, double scale) {
  std::vector<double> sorted;
  for (const auto& value : values) {
    if (value) sorted.push_back(axis.x(*value * scale));
  }
  std::sort(sorted.begin(), sorted.end());
  Html html;
  double first = -1000;
  int stacked = 0;
  for (const double x : sorted) {
    stacked = x - first < 1.6 * dot_radius ? stacked + 1 : 0;
    if (stacked == 0) first = x;
    const int level = (stacked + 1) / 2;
    const double away = 1.7 * dot_radius * level;
    const double y = dot_row + std::min(away, 16.0) * (stacked % 2 == 1 ? -1 : 1);
    html += empty_element("circle", {{"cx", px(x)},
                                     {"cy", px(y)},
                                     {"r", px(dot_radius)},
                                     {"fill", "#0072b2"},
                                     {"fill-opacity", "0.72"}});
  }
  return html;
}

Html median_bar(const Summary& summary, const Axis& axis, double scale) {
  Html html;
  if (summary.median_ci) {
    html += line(axis.x(summary.median_ci->lower * scale), bar_row,
                 axis.x(summary.median_ci->upper * scale), bar_row, "#000", "3");
  }
  const double x = axis.x(*summary.median * scale);
  return html + line(x, bar_row - 8, x, bar_row + 8, "#000", "4");
}

Html drawing(double height, const Html& content, const std::string& label) {
  return element("svg",
                 {{"viewBox", fmt::format("0 0 {} {}", strip_width, height)},
                  {"role", "img"},
                  {"aria-label", label}},
                 content);
}

// Steps from 0 to the last tick.
int tick_count(const Axis& axis) { return static_cast<int>(axis.last * (1 + 1e-9) / axis.step); }

Html grid(const Axis& axis, double height) {
  Html html;
  for (int k = 0; k <= tick_count(axis); ++k) {
    const double x = axis.x(k * axis.step);
    html += line(x, 0, x, height, "#e3e6e9", "1");
  }
  return html;
}

Html strip(const Results& results, const Summary& summary, const Axis& axis) {
  const Measure& measure = item(results.data.measures, summary.measure);
  const std::string name = item(results.data.interfaces, summary.interface);
  const std::string median = "median " + with_unit(measure, *summary.median);
  const std::string ci = summary.median_ci
                             ? "95 % CI " + shown_interval(measure, *summary.median_ci)
                             : "too few for an interval";
  const Html label = element(
      "div", element("b", name) + element("small", median + fmt::format(", n = {}", summary.n)) +
                 element("small", ci));
  const Html picture = grid(axis, strip_height) + dots(summary.values, axis, measure.scale) +
                       median_bar(summary, axis, measure.scale);
  return element("div", {{"class", "strip"}},
                 label + drawing(strip_height, picture, name + ": " + median));
}

Html axis_strip(const Measure& measure, const Axis& axis) {
  Html ticks;
  const int decimals = axis.step < 1 ? static_cast<int>(std::ceil(-std::log10(axis.step))) : 0;
  for (int k = 0; k <= tick_count(axis); ++k) {
    const double tick = k * axis.step;
    ticks += element("text", {{"x", px(axis.x(tick))}, {"y", "16"}, {"text-anchor", "middle"}},
                     text(fixed(tick, decimals)));
  }
  return element("div", {{"class", "strip axis"}},
                 element("small", heading(measure)) + drawing(22, ticks, "scale"));
}

Html dot_chart(const Results& results, const Spotlight& spot) {
  const Measure& measure = item(results.data.measures, spot.measure);
  const auto summaries = results.summaries_of(spot.measure, spot.task);
  double largest = 0;
  for (const Summary* summary : summaries) {
    for (const auto& value : summary->values) largest = std::max(largest, value.value_or(0));
  }
  const Axis axis = axis_up_to(largest * measure.scale);
  Html html;
  for (const Summary* summary : summaries) html += strip(results, *summary, axis);
  return html + axis_strip(measure, axis);
}

// In place of a p that no test could have made small.
std::string too_few(const SignedRankTest& test) {
  if (test.n_zero == test.n && test.n > 1) return fmt::format("n = {}, all equal", test.n);
  if (test.n_zero == 0) return fmt::format("n = {}, too few", test.n);
  return fmt::format("n = {}, {} differ: too few", test.n, test.n - test.n_zero);
}

Html pair_cell(const Measure& measure, const Comparison& pair) {
  if (!pair.hl) return element("td", {{"class", "ns"}}, text("no data"));
  const bool many = pair.test.n - pair.test.n_zero >= 6;
  return element("td", {{"class", is_significant(pair) ? "sig" : "ns"}},
                 text(with_unit(measure, *pair.hl)) +
                     element("span", many ? "p " + p_text(*pair.p_holm) : too_few(pair.test)) +
                     (many ? element("span", fmt::format("n = {}", pair.test.n)) : Html{}));
}

// Rows are a, columns b: the upper triangle of all pairs.
Html triangle(const Results& results, const Spotlight& spot, const std::string& caption) {
  const Measure& measure = item(results.data.measures, spot.measure);
  const auto pairs = results.pairs(spot.measure, spot.task);
  const auto& names = results.data.interfaces;
  const int k = size_of(names);
  Html head = element("td", {{"class", "none"}}, {});
  for (int b = 1; b < k; ++b)
    head += element("th", {{"scope", "col"}}, text("− " + item(names, b)));
  Html rows = element("tr", head);
  std::size_t next = 0;
  for (int a = 0; a + 1 < k; ++a) {
    Html row = element("th", {{"scope", "row"}}, text(item(names, a)));
    for (int b = 1; b < k; ++b) {
      row += b > a ? pair_cell(measure, *pairs[next++]) : element("td", {{"class", "none"}}, {});
    }
    rows += element("tr", row);
  }
  return element("table", {{"class", "triangle"}}, element("caption", caption) + rows);
}

Html panel(const Results& results, const Spotlight& spot) {
  const Measure& measure = item(results.data.measures, spot.measure);
  const std::string task =
      results.data.tasks.size() > 1 ? ", task " + item(results.data.tasks, spot.task).name : "";
  Html right;
  if (results.data.interfaces.size() > 1) {
    const int pairs = results.pairs(spot.measure, spot.task)[0]->family;
    const std::string family = pairs > 1 ? fmt::format(" (Holm over {} pairs)", pairs) : "";
    right = triangle(results, spot, "Difference, row − column, and exact p" + family) +
            element("p", {{"class", "note"}},
                    text("Hodges-Lehmann estimate. Framed and bold: p < .05; grey: not shown to "
                         "differ."));
  }
  return element("div", {{"class", "panel"}},
                 element("div", element("h2", capitalised(measure.label) + task +
                                                  ": one dot per participant, median with 95 % "
                                                  "interval") +
                                    dot_chart(results, spot)) +
                     element("div", right));
}

// Keeps numbers together with what they belong to.
std::string unbroken(const std::string& sentence) {
  std::string result;
  for (std::size_t i = 0; i < sentence.size(); ++i) {
    const auto around = [&](int away) {
      const auto at = i + static_cast<std::size_t>(away);  // wraps around below 0
      return at < sentence.size() ? sentence[at] : ' ';
    };
    const bool digit_before = around(-1) >= '0' && around(-1) <= '9';
    const bool letter_after = around(1) >= 'a' && around(1) <= 'z';
    const bool joins = around(-1) == '=' || around(-1) == '%' || around(-1) == '<' ||
                       around(1) == '=' || around(1) == '<' || around(1) == '%' ||
                       (digit_before && letter_after);
    result += sentence[i] == ' ' && joins ? "\u00a0" : std::string(1, sentence[i]);
  }
  return result;
}

Html link(const std::string& address, const std::string& label) {
  return element("a", {{"href", address}}, text(label));
}

// One part of the bar, as wide as it has people, and its line of the legend.
void add_step(int count, const std::string& name, Html& bar, Html& legend) {
  if (count > 0) {
    bar += element("span", {{"class", name}, {"style", fmt::format("flex: {}", count)}},
                   text(std::to_string(count)));
  }
  const std::string words = fmt::format("{} {}", count, name);
  const bool explained = count > 0 && name == "excluded";
  legend += element("li", element("i", {{"class", name}}, text("\u00a0")) +
                              (explained ? link("#excluded-participants", words) : text(words)));
}

}  // namespace

Html stripe(const Results& results) {
  const Selection& selection = results.selection;
  if (!selection.any_simulated() && !selection.any_pilot()) return {};
  int simulated = 0;
  int pilot = 0;
  for (const Person& person : selection.people) {
    simulated += person.simulated ? 1 : 0;
    pilot += person.pilot && !person.simulated ? 1 : 0;
  }
  std::string words;
  if (simulated > 0) {
    words =
        fmt::format("SIMULATED: {} of {} participants are simulated. Nothing here is about people.",
                    simulated, selection.people.size());
    if (simulated < size_of(selection.people)) {
      words = fmt::format("SIMULATED: {} of {} participants are simulated.", simulated,
                          selection.people.size());
    }
  }
  if (pilot > 0) {
    words += fmt::format("{}PILOT: {} of {} participants took part in pilot sessions.",
                         words.empty() ? "" : " ", pilot, selection.people.size());
  }
  return element("header", {{"class", "stripe"}}, text(words));
}

Html headline(const Results& results) {
  Html html = element("p", {{"class", "study"}},
                      text(fmt::format("{}, version {}", results.log.study, results.log.version)));
  bool first = true;
  for (const Spotlight& spot : spotlights(results)) {
    const std::string sentence = unbroken(sentence_on_measure(results, spot.measure, spot.task));
    html += first ? element("h1", sentence) : element("p", {{"class", "second"}}, text(sentence));
    first = false;
  }
  if (first) {
    html += element("h1", fmt::format("{} rated walks, {} in all; nothing was made with an "
                                      "interface.",
                                      count_of(size_of(results.data.people), "person", "people"),
                                      count_of(results.rated_walks, "rating", "ratings")));
  }
  for (const std::string& caveat : caveats(results)) {
    html += element("p", {{"class", "caveat"}}, text(caveat));
  }
  return html;
}

Html sensitivity_links(const Results& results) {
  Html html;
  for (const std::string& sentence : results.sensitivity.sentences) {
    html += element("p", {{"class", "sensitivity"}}, link("#sensitivity", unbroken(sentence)));
  }
  if (results.prereg) {
    const int deviations = size_of(results.prereg->deviations);
    html +=
        element("p", {{"class", "sensitivity"}},
                link("#preregistration",
                     "Preregistered: " + count_of(size_of(results.prereg->tests), "test", "tests") +
                         " planned, " + count_of(deviations, "deviation", "deviations") + "."));
  }
  return html;
}

Html flow_bar(const Results& results) {
  const Flow& flow = results.flow;
  const Selection& selection = results.selection;
  Html bar, legend;
  if (flow.booked > 0) {
    legend += element("li", count_of(flow.booked, "place", "places") + " booked");
    add_step(flow.no_show, "no-show", bar, legend);
    if (flow.replaced > 0) add_step(flow.replaced, "replaced", bar, legend);
    if (flow.expected > 0) add_step(flow.expected, "expected", bar, legend);
  }
  legend += element("li", count_of(flow.began, "participant", "participants") + " began");
  add_step(flow.declined, "declined", bar, legend);
  add_step(flow.withdrawn, "withdrawn", bar, legend);
  add_step(flow.unfinished, "unfinished", bar, legend);
  add_step(flow.excluded, "excluded", bar, legend);
  add_step(flow.analysed, "analysed", bar, legend);
  if (selection.left_out_simulated > 0) {
    legend += element(
        "li", fmt::format("not in this report: {} simulated", selection.left_out_simulated));
  }
  if (selection.left_out_pilot > 0) {
    legend += element("li", fmt::format("not in this report: {} pilot", selection.left_out_pilot));
  }
  return element("section", {{"class", "flow"}, {"aria-label", "Flow of participants"}},
                 element("div", {{"class", "bar"}}, bar) + element("ul", legend));
}

Html panels(const Results& results) {
  Html html;
  for (const Spotlight& spot : spotlights(results)) html += panel(results, spot);
  return html;
}

Html buttons() {
  Html html = link("#data", "Data");
  html += link("analysis.R", "R script");
  html += link("#figures", "PDF figures");
  return element("nav", {{"class", "buttons"}, {"aria-label", "Files"}}, html);
}

}  // namespace promenade::analysis
