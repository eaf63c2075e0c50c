// Tables that people make elsewhere.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace promenade::study {

struct CsvRow {
  int line = 0;  // from 1
  std::vector<std::string> cells;
};

// Rows of comma-separated text (RFC 4180: quotes, CRLF); empty lines are left out. A
// byte order mark is skipped.
std::vector<CsvRow> parse_csv(std::string_view text);

}  // namespace promenade::study
