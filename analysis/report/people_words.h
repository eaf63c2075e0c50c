// Small words and cells that the sections about people and sessions share.
#pragma once

#include <optional>
#include <string>

#include "analysis/dataset.h"
#include "analysis/format.h"
#include "analysis/item.h"
#include "analysis/report/cells.h"
#include "analysis/report/html.h"
#include "analysis/statistics/interval.h"

namespace promenade::analysis {

inline std::string range_or_none(const std::optional<Interval>& interval, int decimals) {
  return interval ? fixed(interval->lower, decimals) + " to " + fixed(interval->upper, decimals)
                  : dash;
}
// In the unit of the measure: "0.4 [0.1, 0.6]".
inline std::string estimate_of(const Measure& measure, const std::optional<double>& estimate,
                               const std::optional<Interval>& interval) {
  if (!estimate) return dash;
  std::string words = with_unit(measure, *estimate);
  if (interval) {
    words += " [" + shown(measure, interval->lower) + ", " + shown(measure, interval->upper) + "]";
  }
  return words;
}

inline std::string share_of(int count, int all) {
  return all > 0 ? fixed(100.0 * count / all, 0) + " %" : dash;
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
