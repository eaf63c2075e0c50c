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

namespace {

// Splits text as it stands; one instance reads one table.
class CsvReader {
 public:
  explicit CsvReader(std::string_view text) : text_(text) {
    if (text_.substr(0, 3) == "\xEF\xBB\xBF") text_.remove_prefix(3);
  }

  std::vector<CsvRow> rows() {
    while (at_ < text_.size()) {
      CsvRow row{line_, {}};
      do {
        row.cells.push_back(cell());
      } while (take(','));
      take('\r');
      if (take('\n')) ++line_;
      if (row.cells.size() > 1 || !row.cells[0].empty()) rows_.push_back(std::move(row));
    }
    return std::move(rows_);
  }

 private:
  bool take(char c) {
    if (at_ >= text_.size() || text_[at_] != c) return false;
    ++at_;
    return true;
  }
  std::string cell() {
    if (take('"')) return quoted();
    const std::size_t end = std::min(text_.find_first_of(",\r\n", at_), text_.size());
    std::string result(text_.substr(at_, end - at_));
    at_ = end;
    // A carriage return alone ends no line: it is skipped.
    if (at_ < text_.size() && text_[at_] == '\r' &&
        (at_ + 1 == text_.size() || text_[at_ + 1] != '\n'))
      ++at_;
    return result;
  }
  std::string quoted() {
    std::string result;
    while (at_ < text_.size()) {
      if (take('"')) {
        if (!take('"')) break;
        result += '"';
        continue;
      }
      if (text_[at_] == '\n') ++line_;
      result += text_[at_++];
    }
    // Letters behind the closing quote belong to the cell.
    const std::size_t end = std::min(text_.find_first_of(",\r\n", at_), text_.size());
    result += text_.substr(at_, end - at_);
    at_ = end;
    return result;
  }

  std::string_view text_;
  std::size_t at_ = 0;
  int line_ = 1;
  std::vector<CsvRow> rows_;
};

}  // namespace

std::vector<CsvRow> parse_csv(std::string_view text) { return CsvReader(text).rows(); }

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
