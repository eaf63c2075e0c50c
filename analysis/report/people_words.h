// Small words and cells that the sections about people and sessions share.
#pragma once

#include <optional>
#include <string>

#include "analysis/dataset.h"
#include "analysis/format.h"
#include "analysis/item.h"
#include "analysis/report/html.h"
#include "analysis/statistics/interval.h"

namespace promenade::analysis {

inline constexpr const char* no_value = "–";

inline std::string fixed_or_none(const std::optional<double>& value, int decimals) {
  return value ? fixed(*value, decimals) : no_value;
}
inline std::string range_or_none(const std::optional<Interval>& interval, int decimals) {
  return interval ? fixed(interval->lower, decimals) + " to " + fixed(interval->upper, decimals)
                  : no_value;
}
// ".042", "< .001": for a column of p.
inline std::string p_or_none(const std::optional<double>& p) {
  if (!p) return no_value;
  const std::string words = p_text(*p);
  return words[0] == '=' ? words.substr(2) : words;
}
// In the unit of the measure: "0.4 [0.1, 0.6]".
inline std::string estimate_of(const Measure& measure, const std::optional<double>& estimate,
                               const std::optional<Interval>& interval) {
  if (!estimate) return no_value;
  std::string words = with_unit(measure, *estimate);
  if (interval) {
    words += " [" + shown(measure, interval->lower) + ", " + shown(measure, interval->upper) + "]";
  }
  return words;
}

inline std::string share_of(int count, int all) {
  return all > 0 ? fixed(100.0 * count / all, 0) + " %" : no_value;
}

// "final D, match": the task where there are several.
inline std::string measure_in_task(const Dataset& data, int measure, int task) {
  const std::string label = item(data.measures, measure).label;
  return data.tasks.size() > 1 ? label + ", " + item(data.tasks, task).name : label;
}

// A table in a box of its own, which scrolls where it is too wide; nothing without rows.
inline Html boxed(const HtmlTable& table, const char* look = "wide") {
  return table.rows.empty() ? Html{} : element("div", {{"class", look}}, render(table));
}

}  // namespace promenade::analysis
