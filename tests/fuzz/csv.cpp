// Any bytes as a table, and as ratings with and without a set of motions. A table that is
// written again holds the same cells.
#include "study/csv.h"

#include <cstdint>
#include <cstdlib>
#include <string>

#include "motion/problem.h"
#include "study/ratings_csv.h"

namespace {

using namespace promenade;

void write_again(const std::vector<study::CsvRow>& rows) {
  std::string text = "first\n";  // a mark of the byte order in a cell stays in it
  for (const study::CsvRow& row : rows) {
    for (std::size_t c = 0; c < row.cells.size(); ++c) {
      text += (c > 0 ? "," : "") + study::csv_cell(row.cells[c]);
    }
    text += '\n';
  }
  const std::vector<study::CsvRow> again = study::parse_csv(text);
  if (again.size() != rows.size() + 1) std::abort();
  for (std::size_t r = 0; r < rows.size(); ++r) {
    if (again[r + 1].cells != rows[r].cells) std::abort();
  }
}

// Places ascend, and each cell has one.
void check_places(const std::vector<study::CsvRow>& rows) {
  Place last;
  for (const study::CsvRow& row : rows) {
    if (row.places.size() != row.cells.size()) std::abort();
    for (const Place& place : row.places) {
      const bool after =
          place.line > last.line || (place.line == last.line && place.column > last.column);
      if (!after || place.column < 1) std::abort();
      last = place;
    }
  }
}

void read(std::string_view text, const std::vector<std::string>& motions) {
  try {
    const study::RatingsTable table = study::read_ratings_csv("fuzz.csv", text, motions);
    if (table.ratings.empty() || table.ratings.size() > text.size()) std::abort();
  } catch (const InputError&) {
    // Refused with a place and a reason: that is what should happen.
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  const std::vector<study::CsvRow> rows = study::parse_csv(text);
  write_again(rows);
  check_places(rows);
  read(text, {});
  read(text, {"happy", "sad"});
  return 0;
}
