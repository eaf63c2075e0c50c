// Numbers that people type, for commands.
#pragma once

#include <Eigen/Dense>
#include <string>
#include <vector>

#include "study/csv.h"

namespace promenade::app {

// "0.5,0.25,0.25" as numbers; `option` names it in the InputError with all that is wrong.
Eigen::VectorXd parse_numbers(const std::string& option, const std::string& text);

// For JSON.
std::vector<double> to_list(const Eigen::Ref<const Eigen::VectorXd>& values);

using study::csv_cell;

}  // namespace promenade::app
