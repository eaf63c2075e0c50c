#include "analysis/exclusions.h"

#include <algorithm>

#include "motion/problem.h"

namespace promenade::analysis {
namespace {

// The fields of one line of CSV, without line end.
std::vector<std::string> csv_fields(std::string_view line) {
  std::vector<std::string> fields(1);
  bool quoted = false;
  for (std::size_t i = 0; i < line.size(); ++i) {
    if (line[i] == '"' && quoted && i + 1 < line.size() && line[i + 1] == '"') {
      fields.back() += line[++i];
    } else if (line[i] == '"') {
      quoted = !quoted;
    } else if (line[i] == ',' && !quoted) {
      fields.emplace_back();
    } else {
      fields.back() += line[i];
    }
  }
  return fields;
}

std::string trimmed(const std::string& text) {
  const char* spaces = " \t\r";
  const std::size_t first = text.find_first_not_of(spaces);
  if (first == std::string::npos) return "";
  return text.substr(first, text.find_last_not_of(spaces) - first + 1);
}

}  // namespace

std::vector<Exclusion> parse_exclusions(const std::string& file, std::string_view text) {
  std::vector<Exclusion> exclusions;
  std::vector<Problem> problems;
  if (text.substr(0, 3) == "\xEF\xBB\xBF") text.remove_prefix(3);  // of spreadsheets
  int line = 0;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    std::vector<std::string> fields = csv_fields(text.substr(0, end));
    text.remove_prefix(std::min(end + 1, text.size()));
    ++line;
    const std::string code = trimmed(fields[0]);
    const std::string reason = fields.size() > 1 ? trimmed(fields[1]) : "";
    const bool blank = code.empty() && fields.size() == 1;
    if (blank || (line == 1 && code == "code")) continue;
    if (code.empty() || fields.size() > 2) {
      problems.push_back({file, line, 1, "want CODE,REASON here", Severity::error});
    } else {
      exclusions.push_back({code, reason, line});
    }
  }
  if (!problems.empty()) throw InputError(std::move(problems));
  return exclusions;
}

}  // namespace promenade::analysis
