#include "analysis/format.h"

#include <fmt/format.h>

#include <cmath>

namespace promenade::analysis {

std::string fixed(double value, int decimals) {
  std::string text = fmt::format("{:.{}f}", std::abs(value), decimals);
  const bool is_zero = text.find_first_not_of("0.") == std::string::npos;
  return value < 0 && !is_zero ? "−" + text : text;
}

std::string exact_number(double value) { return fmt::format("{}", value); }

std::string p_text(double p) {
  if (p < 0.001) return "< .001";
  const std::string text = fixed(p, 3);
  return text[0] == '1' ? "= 1" : "= " + text.substr(1);
}

std::string shown(const Measure& measure, double value) {
  return fixed(value * measure.scale, measure.decimals);
}

std::string with_unit(const Measure& measure, double value) {
  return shown(measure, value) + (measure.shown_unit.empty() ? "" : " " + measure.shown_unit);
}

std::string shown_interval(const Measure& measure, const Interval& interval) {
  return shown(measure, interval.lower) + " to " + shown(measure, interval.upper);
}

std::string heading(const Measure& measure) {
  const std::string label = capitalised(measure.label);
  return measure.shown_unit.empty() ? label : label + " (" + measure.shown_unit + ")";
}

std::string count_of(int count, const std::string& one, const std::string& many) {
  return fmt::format("{} {}", count, count == 1 ? one : many);
}

std::string capitalised(std::string sentence) {
  if (!sentence.empty() && sentence[0] >= 'a' && sentence[0] <= 'z') {
    sentence[0] = static_cast<char>(sentence[0] - 'a' + 'A');
  }
  return sentence;
}

std::string listed(const std::vector<std::string>& names) {
  std::string text;
  for (const std::string& name : names) text += (text.empty() ? "" : ", ") + name;
  return text;
}

}  // namespace promenade::analysis
