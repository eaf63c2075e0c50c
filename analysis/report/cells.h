// Values as cells of tables/*.csv and of report.json: what is not defined is empty, or null.
#pragma once

#include <cmath>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "analysis/report/tables.h"
#include "analysis/statistics/interval.h"

namespace promenade::analysis {

inline Cell cell_of(const std::optional<double>& value) {
  return value && std::isfinite(*value) ? Cell(*value) : Cell();
}
inline Cell cell_of(int value) { return std::int64_t{value}; }
inline Cell cell_of(bool value) { return std::int64_t{value ? 1 : 0}; }
inline Cell cell_of(const std::string& text) { return text; }
inline Cell lower_of(const std::optional<Interval>& interval) {
  return interval ? cell_of(std::optional(interval->lower)) : Cell();
}
inline Cell upper_of(const std::optional<Interval>& interval) {
  return interval ? cell_of(std::optional(interval->upper)) : Cell();
}

// One object for each row, its keys the columns: what a table of the page says, in report.json.
inline nlohmann::json rows_json(const Table& table) {
  struct Value {
    nlohmann::json operator()(std::monostate) const { return nullptr; }
    nlohmann::json operator()(std::int64_t value) const { return value; }
    nlohmann::json operator()(double value) const { return value; }
    nlohmann::json operator()(const std::string& text) const { return text; }
  };
  nlohmann::json rows = nlohmann::json::array();
  for (const std::vector<Cell>& row : table.rows) {
    nlohmann::json object;
    for (std::size_t i = 0; i < row.size(); ++i)
      object[table.columns[i]] = std::visit(Value(), row[i]);
    rows.push_back(std::move(object));
  }
  return rows;
}

}  // namespace promenade::analysis
