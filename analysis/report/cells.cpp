#include "analysis/report/cells.h"

#include <cmath>

#include "analysis/format.h"
#include "analysis/item.h"

namespace promenade::analysis {
namespace {

struct JsonValue {
  nlohmann::json operator()(std::monostate) const { return nullptr; }
  template <typename Value>
  nlohmann::json operator()(const Value& value) const {
    return value;
  }
};

}  // namespace

Cell cell(const std::optional<double>& value) { return value ? cell(*value) : Cell(); }
Cell cell(double value) { return std::isfinite(value) ? Cell(value) : Cell(); }
Cell cell(int value) { return std::int64_t{value}; }
Cell cell(bool value) { return std::int64_t{value ? 1 : 0}; }
Cell cell(const std::string& text) { return text; }
Cell cell(const char* text) { return std::string(text); }

Cell target_name(const Dataset& data, int task, int target) {
  if (target < 0) return {};
  return item(item(data.tasks, task).targets, target);
}

Cell lower(const std::optional<Interval>& interval) {
  return interval ? cell(interval->lower) : Cell();
}
Cell upper(const std::optional<Interval>& interval) {
  return interval ? cell(interval->upper) : Cell();
}

nlohmann::json json_rows(const Table& table) {
  nlohmann::json rows = nlohmann::json::array();
  for (const std::vector<Cell>& row : table.rows) {
    nlohmann::json object = nlohmann::json::object();
    for (int i = 0; i < size_of(row); ++i) {
      object[item(table.columns, i)] = std::visit(JsonValue(), item(row, i));
    }
    rows.push_back(std::move(object));
  }
  return rows;
}

std::string p_cell(const std::optional<double>& p) {
  if (!p) return dash;
  const std::string words = p_text(*p);
  return words[0] == '=' ? words.substr(2) : words;
}

std::string number_cell(const std::optional<double>& value, int decimals) {
  return value ? fixed(*value, decimals) : dash;
}

// W can end in one half.
std::string rank_sum(double w) { return fixed(w, w == std::floor(w) ? 0 : 1); }

std::string range_cell(const std::optional<Interval>& interval, int decimals) {
  return interval ? fixed(interval->lower, decimals) + " to " + fixed(interval->upper, decimals)
                  : dash;
}

std::string percent(double share) { return fixed(100 * share, 0) + " %"; }

std::string percent_of(int count, int all) {
  return all > 0 ? percent(static_cast<double>(count) / all) : dash;
}

std::string percent_interval(const Interval& shares) {
  return fixed(100 * shares.lower, 0) + " to " + fixed(100 * shares.upper, 0) + " %";
}

std::string target_words(const Dataset& data, int task, int target) {
  return target < 0 ? "all" : item(item(data.tasks, task).targets, target);
}

std::string pair_name(const Dataset& data, int a, int b) {
  return item(data.interfaces, a) + " −\u00a0" + item(data.interfaces, b);
}

std::string estimate_cell(const Measure& measure, const std::optional<double>& estimate,
                          const std::optional<Interval>& interval) {
  if (!estimate) return dash;
  const std::string words = with_unit(measure, *estimate);
  if (!interval) return words;
  return words + " [" + shown(measure, interval->lower) + ", " + shown(measure, interval->upper) +
         "]";
}

std::string measure_in_task(const Dataset& data, int measure, int task) {
  const std::string label = item(data.measures, measure).label;
  return data.tasks.size() > 1 ? label + ", " + item(data.tasks, task).name : label;
}

Html wide(const HtmlTable& table) {
  return table.rows.empty() ? Html{} : element("div", {{"class", "wide"}}, render(table));
}
Html wide_words(const HtmlTable& table) {
  return table.rows.empty() ? Html{} : element("div", {{"class", "wide text"}}, render(table));
}

Html folded(const HtmlTable& table) {
  constexpr std::size_t shown_rows = 16;
  if (table.rows.size() <= shown_rows) return wide(table);
  const std::string size = "Show " + std::to_string(table.rows.size()) + " rows: ";
  const std::string what = table.caption.substr(0, table.caption.find(". "));
  return element("details", element("summary", size + what) + wide(table));
}

Html note(const std::string& sentence) { return element("p", {{"class", "note"}}, text(sentence)); }

std::string of_task(const Dataset& data, int task) {
  return data.tasks.size() > 1 ? capitalised(item(data.tasks, task).name) + ": " : "";
}

}  // namespace promenade::analysis
