#include "analysis/families/family.h"

#include <algorithm>
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

std::vector<std::optional<double>> as_numbers_or_null(const Json& value, const char* key) {
  std::vector<std::optional<double>> result;
  for (const Json& item : list(value, key)) {
    if (item.is_null()) {
      result.emplace_back();
    } else {
      result.emplace_back(as_number(item, key));
    }
  }
  return result;
}

template <typename Row>
void require_equal_lengths(const std::vector<Row>& rows, const char* key) {
  for (const Row& row : rows) {
    if (row.size() != rows[0].size()) {
      throw CaseError(std::string("the rows of input.") + key + " differ in length");
    }
  }
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

std::string text(const Json& input, const char* key) {
  const Json& value = member(input, key);
  if (!value.is_string()) throw CaseError(std::string("input.") + key + " is no text");
  return value.get<std::string>();
}

std::vector<std::optional<double>> numbers_or_null(const Json& input, const char* key) {
  return as_numbers_or_null(member(input, key), key);
}

std::vector<std::vector<double>> matrix(const Json& input, const char* key) {
  std::vector<std::vector<double>> rows;
  for (const Json& row : list(member(input, key), key)) rows.push_back(as_numbers(row, key));
  if (rows.empty() || rows[0].empty()) throw CaseError(std::string("input.") + key + " is empty");
  require_equal_lengths(rows, key);
  return rows;
}

std::vector<std::vector<std::optional<double>>> matrix_or_null(const Json& input, const char* key) {
  std::vector<std::vector<std::optional<double>>> rows;
  for (const Json& row : list(member(input, key), key)) {
    rows.push_back(as_numbers_or_null(row, key));
  }
  require_equal_lengths(rows, key);
  return rows;
}

Labels labels(const Json& input, const char* key) {
  const Json& names = list(member(input, key), key);
  for (const Json& name : names) {
    if (!name.is_number() && !name.is_string()) {
      throw CaseError(std::string("input.") + key + " is not all numbers or texts");
    }
  }
  std::vector<Json> sorted(names.begin(), names.end());
  std::sort(sorted.begin(), sorted.end());
  sorted.erase(std::unique(sorted.begin(), sorted.end()), sorted.end());
  Labels result;
  result.count = static_cast<int>(sorted.size());
  for (const Json& name : names) {
    const auto found = std::lower_bound(sorted.begin(), sorted.end(), name);
    result.places.push_back(static_cast<int>(found - sorted.begin()));
  }
  return result;
}

std::vector<Duration> durations_of(const Json& input) {
  const std::vector<double> times = numbers(input, "time");
  const std::vector<double> events = numbers(input, "event");
  if (times.size() != events.size()) throw CaseError("input.time and input.event differ in length");
  std::vector<Duration> durations;
  for (std::size_t i = 0; i < times.size(); ++i) {
    if (times[i] < 0) throw CaseError("input.time holds a negative time");
    if (events[i] != 0 && events[i] != 1) throw CaseError("input.event is not all 0 or 1");
    durations.push_back({times[i], events[i] == 1});
  }
  return durations;
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
