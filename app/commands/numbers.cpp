#include "app/commands/numbers.h"

#include <charconv>
#include <cmath>

#include "motion/problem.h"

namespace promenade::app {

std::optional<double> parse_number(std::string_view text) {
  while (!text.empty() && text.front() == ' ') text.remove_prefix(1);
  while (!text.empty() && text.back() == ' ') text.remove_suffix(1);
  if (!text.empty() && text.front() == '+') text.remove_prefix(1);
  double value = 0;
  const auto [stop, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || stop != text.data() + text.size() || !std::isfinite(value)) return {};
  return value;
}

Eigen::VectorXd parse_numbers(const std::string& option, const std::string& text) {
  std::vector<double> values;
  std::vector<Problem> problems;
  for (std::size_t at = 0; at <= text.size();) {
    const std::size_t end = std::min(text.find(',', at), text.size());
    const std::string word = text.substr(at, end - at);
    if (const auto value = parse_number(word)) {
      values.push_back(*value);
    } else {
      problems.push_back({option, 0, 0, "\"" + word + "\" is not a number", Severity::error});
    }
    at = end + 1;
  }
  if (!problems.empty()) throw InputError(problems);
  return Eigen::Map<Eigen::VectorXd>(values.data(), static_cast<Eigen::Index>(values.size()));
}

std::vector<double> to_list(const Eigen::Ref<const Eigen::VectorXd>& values) {
  return {values.begin(), values.end()};
}

std::string csv_cell(std::string_view text) {
  if (text.find_first_of(",\"\r\n") == std::string_view::npos) return std::string(text);
  std::string result = "\"";
  for (const char c : text) {
    if (c == '"') result += '"';
    result += c;
  }
  return result + '"';
}

}  // namespace promenade::app
