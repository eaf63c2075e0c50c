#include "study/csv.h"

#include <algorithm>

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

}  // namespace promenade::study
