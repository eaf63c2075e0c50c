// Numbers and tables that people type or export from elsewhere, for commands.
#pragma once

#include <Eigen/Dense>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "study/csv.h"

namespace promenade::app {

// A whole number in the C notation, finite, whatever the locale; else nothing.
std::optional<double> parse_number(std::string_view text);

// "0.5,0.25,0.25" as numbers; `option` names it in the InputError with all that is wrong.
Eigen::VectorXd parse_numbers(const std::string& option, const std::string& text);

// For JSON.
std::vector<double> to_list(const Eigen::Ref<const Eigen::VectorXd>& values);

using study::CsvRow;
using study::parse_csv;

// Quoted when it must be.
std::string csv_cell(std::string_view text);

}  // namespace promenade::app
