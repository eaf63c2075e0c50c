#include "study/csv.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

#include "study/utf8.h"

namespace promenade::study {
namespace {

// Splits text as it stands; one instance reads one table.
class CsvReader {
 public:
  explicit CsvReader(std::string_view text) : text_(text) {
    if (text_.substr(0, 3) == "\xEF\xBB\xBF") text_.remove_prefix(3);
  }

  std::vector<CsvRow> rows() {
    while (at_ < text_.size()) {
      CsvRow row{line_, {}, {}};
      do {
        row.places.push_back({line_, column()});
        row.cells.push_back(cell());
      } while (take(','));
      take('\r');
      if (take('\n')) begin_line();
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
  void begin_line() {
    ++line_;
    counted_at_ = at_;
    column_ = 1;
  }
  // Of the next character.
  int column() {
    for (; counted_at_ < at_; ++counted_at_) {
      if (begins_character(text_[counted_at_])) ++column_;
    }
    return column_;
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
      const char letter = text_[at_++];
      result += letter;
      if (letter == '\n') begin_line();
    }
    // Letters behind the closing quote belong to the cell.
    const std::size_t end = std::min(text_.find_first_of(",\r\n", at_), text_.size());
    result += text_.substr(at_, end - at_);
    at_ = end;
    return result;
  }

  std::string_view text_;
  std::size_t at_ = 0;
  std::size_t counted_at_ = 0;  // the character of column_
  int line_ = 1, column_ = 1;
  std::vector<CsvRow> rows_;
};

}  // namespace

Place CsvRow::place(std::size_t cell) const {
  return places.empty() ? Place{line, 1} : places[std::min(cell, places.size() - 1)];
}

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

std::string csv_line(const std::vector<std::string>& cells) {
  std::string line;
  for (std::size_t i = 0; i < cells.size(); ++i) {
    if (i > 0) line += ',';
    line += csv_cell(cells[i]);
  }
  return line + '\n';
}

std::string csv_number(double value) {
  std::array<char, 32> digits{};
  const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), value).ptr;
  return {digits.data(), end};
}

std::optional<double> parse_number(std::string_view text) {
  while (!text.empty() && text.front() == ' ') text.remove_prefix(1);
  while (!text.empty() && text.back() == ' ') text.remove_suffix(1);
  if (!text.empty() && text.front() == '+') text.remove_prefix(1);
  double value = 0;
  const auto [stop, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || stop != text.data() + text.size() || !std::isfinite(value)) return {};
  return value;
}

}  // namespace promenade::study
