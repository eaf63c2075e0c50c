#include "analysis/exclusions.h"

#include "motion/problem.h"
#include "study/csv.h"

namespace promenade::analysis {
namespace {

std::string trimmed(const std::string& text) {
  const char* spaces = " \t\r";
  const std::size_t first = text.find_first_not_of(spaces);
  if (first == std::string::npos) return "";
  return text.substr(first, text.find_last_not_of(spaces) - first + 1);
}

bool is_header(const std::string& cell) {
  return cell == "code" || cell == "Code" || cell == "CODE";
}

}  // namespace

std::vector<Exclusion> parse_exclusions(const std::string& file, std::string_view text) {
  std::vector<Exclusion> exclusions;
  std::vector<Problem> problems;
  for (const study::CsvRow& row : study::parse_csv(text)) {
    const std::string code = trimmed(row.cells[0]);
    const std::string reason = row.cells.size() > 1 ? trimmed(row.cells[1]) : "";
    const bool blank = code.empty() && row.cells.size() == 1;
    if (blank || (row.line == 1 && is_header(code))) continue;
    if (code.empty() || row.cells.size() > 2) {
      const Place place = row.place(code.empty() ? 0 : 2);
      problems.push_back(
          {file, place.line, place.column, "want CODE,REASON here", Severity::error});
    } else {
      exclusions.push_back({code, reason, row.line});
    }
  }
  if (!problems.empty()) throw InputError(std::move(problems));
  return exclusions;
}

}  // namespace promenade::analysis
