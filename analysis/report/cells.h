// Cells of the tables of a report: words for the page, exact values for CSV, and the rows of a
// CSV as JSON, so that the three say the same.
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "analysis/report/html.h"
#include "analysis/report/tables.h"

namespace promenade::analysis {

inline constexpr const char* dash = "–";  // in place of a number that is not defined

// For CSV; what is missing or not finite is an empty cell.
Cell cell(const std::optional<double>& value);
Cell cell(double value);
Cell cell(int value);
Cell cell(bool value);
Cell cell(const std::string& text);
Cell cell(const char* text);
Cell target_name(const Dataset& data, int task, int target);  // -1: empty
Cell lower(const std::optional<Interval>& interval);
Cell upper(const std::optional<Interval>& interval);

// The rows of a table as objects, with the columns as keys.
nlohmann::json json_rows(const Table& table);

// For the page.
std::string p_cell(const std::optional<double>& p);                             // ".042", "< .001"
std::string number_cell(const std::optional<double>& value, int decimals);      // "0.42"
std::string rank_sum(double w);                                                 // "12.5", "12"
std::string range_cell(const std::optional<Interval>& interval, int decimals);  // "0.1 to 0.6"
std::string percent(double share);                                              // "25 %"
std::string percent_of(int count, int all);                                     // of none: a dash
std::string percent_interval(const Interval& shares);                           // "12 to 43 %"
std::string target_words(const Dataset& data, int task, int target);            // -1: "all"
std::string pair_name(const Dataset& data, int a, int b);                       // "map − labels"

// "0.4 cm [0.1, 0.6]".
std::string estimate_cell(const Measure& measure, const std::optional<double>& estimate,
                          const std::optional<Interval>& interval);
// "final D, match": the task where there are several.
std::string measure_in_task(const Dataset& data, int measure, int task);

// A table that may be wider than a narrow page; nothing without rows. Of numbers, and of words.
Html wide(const HtmlTable& table);
Html wide_words(const HtmlTable& table);
// A table of details: where it is long, only its caption shows until somebody opens it. On paper it
// is open.
Html folded(const HtmlTable& table);
Html note(const std::string& sentence);

// "map: ", or nothing where there is only one task: how a caption begins.
std::string of_task(const Dataset& data, int task);

}  // namespace promenade::analysis
