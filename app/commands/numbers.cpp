#include "app/commands/numbers.h"

#include "motion/problem.h"

namespace promenade::app {

Eigen::VectorXd parse_numbers(const std::string& option, const std::string& text) {
  std::vector<double> values;
  std::vector<Problem> problems;
  for (std::size_t at = 0; at <= text.size();) {
    const std::size_t end = std::min(text.find(',', at), text.size());
    const std::string word = text.substr(at, end - at);
    if (const auto value = study::parse_number(word)) {
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

}  // namespace promenade::app
