#include "analysis/families/family.h"

#include <cmath>
#include <limits>

namespace promenade::analysis::families {
namespace {

const Json& member(const Json& input, const char* key) {
  const auto found = input.find(key);
  if (found == input.end()) throw CaseError(std::string("input.") + key + " is missing");
  return *found;
}

const Json& list(const Json& value, const char* key) {
  if (!value.is_array()) throw CaseError(std::string("input.") + key + " is not a list");
  return value;
}

double as_number(const Json& value, const char* key) {
  if (value.is_string()) {
    throw CaseError(std::string("input.") + key + " holds \"" + value.get<std::string>() +
                    "\", which is no number or out of range");
  }
  if (!value.is_number()) throw CaseError(std::string("input.") + key + " is not all numbers");
  return value.get<double>();
}

std::vector<double> as_numbers(const Json& value, const char* key) {
  std::vector<double> result;
  for (const Json& item : list(value, key)) result.push_back(as_number(item, key));
  return result;
}

}  // namespace

double number(const Json& input, const char* key) { return as_number(member(input, key), key); }

int whole_number(const Json& input, const char* key) {
  const double value = number(input, key);
  if (value < 0 || value > std::numeric_limits<int>::max() || value != std::floor(value)) {
    throw CaseError(std::string("input.") + key + " is not a whole number from 0");
  }
  return static_cast<int>(value);
}

double level(const Json& input, const char* key) {
  const double value = number(input, key);
  if (!(value > 0 && value < 1)) {
    throw CaseError(std::string("input.") + key + " is not between 0 and 1");
  }
  return value;
}

std::vector<double> numbers(const Json& input, const char* key) {
  return as_numbers(member(input, key), key);
}

std::vector<std::optional<double>> numbers_or_null(const Json& input, const char* key) {
  std::vector<std::optional<double>> result;
  for (const Json& item : list(member(input, key), key)) {
    if (item.is_null()) {
      result.emplace_back();
    } else {
      result.emplace_back(as_number(item, key));
    }
  }
  return result;
}

std::vector<std::vector<double>> matrix(const Json& input, const char* key) {
  std::vector<std::vector<double>> rows;
  for (const Json& row : list(member(input, key), key)) rows.push_back(as_numbers(row, key));
  if (rows.empty() || rows[0].empty()) throw CaseError(std::string("input.") + key + " is empty");
  for (const auto& row : rows) {
    if (row.size() != rows[0].size()) {
      throw CaseError(std::string("the rows of input.") + key + " differ in length");
    }
  }
  return rows;
}

Eigen::MatrixXd table(const Json& input, const char* key) {
  const auto rows = matrix(input, key);
  Eigen::MatrixXd result(rows.size(), rows[0].size());
  for (std::size_t r = 0; r < rows.size(); ++r) {
    result.row(static_cast<Eigen::Index>(r)) =
        Eigen::Map<const Eigen::RowVectorXd>(rows[r].data(), result.cols());
  }
  return result;
}

Eigen::MatrixXd distance_table(const Json& input, const char* key) {
  Eigen::MatrixXd distances = table(input, key);
  if (distances.rows() != distances.cols()) {
    throw CaseError(std::string("input.") + key + " is not square");
  }
  const double rounding = 1e-9 * distances.cwiseAbs().maxCoeff();
  if ((distances - distances.transpose()).cwiseAbs().maxCoeff() > rounding) {
    throw CaseError(std::string("input.") + key + " is not symmetric");
  }
  if (distances.minCoeff() < 0) throw CaseError(std::string("input.") + key + " is negative");
  return distances;
}

Json to_json(const std::optional<double>& value) {
  return value && std::isfinite(*value) ? Json(*value) : Json();
}

Json to_json(const Interval& interval) { return Json::array({interval.lower, interval.upper}); }

Json to_json(const std::optional<Interval>& interval) {
  return interval ? to_json(*interval) : Json();
}

}  // namespace promenade::analysis::families
