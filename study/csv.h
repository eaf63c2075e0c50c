// Tables that people make elsewhere, and numbers as they write them.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "motion/place.h"

namespace promenade::study {

struct CsvRow {
  int line = 0;  // from 1
  std::vector<std::string> cells;
  std::vector<Place> places;  // of the cells; columns count characters

  // Of a cell, or of where the last one begins if the row has fewer.
  Place place(std::size_t cell) const;
};

// Rows of comma-separated text (RFC 4180: quotes, CRLF); empty lines are left out. A
// byte order mark is skipped.
std::vector<CsvRow> parse_csv(std::string_view text);

// As a cell of such a table: quoted when it must be.
std::string csv_cell(std::string_view text);

// A row of cells that are text already, with its end of line (LF).
std::string csv_line(const std::vector<std::string>& cells);

// The fewest digits that read back as the same double, "." before decimals; "inf", "-inf".
std::string csv_number(double value);

// A whole number in the C notation, finite, whatever the locale; else nothing.
std::optional<double> parse_number(std::string_view text);

}  // namespace promenade::study
