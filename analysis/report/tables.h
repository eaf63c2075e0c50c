// The numbers behind a report as CSV: full precision, one table per file, ready for
// any other program.
#pragma once

#include <cstdint>
#include <string>
#include <variant>
#include <vector>

#include "analysis/results.h"

namespace promenade::analysis {

using Cell = std::variant<std::monostate, std::string, std::int64_t, double>;

struct Table {
  std::string name;     // of the file, without ".csv"
  std::string caption;  // one sentence: what a row is
  std::vector<std::string> columns;
  std::vector<std::vector<Cell>> rows;
};

// comparisons, failures, summaries, participants, values, trials, measures.
std::vector<Table> make_tables(const Results& results);

// RFC 4180 with LF line ends: quotes where needed, empty where there is no value,
// the shortest numbers that read back the same.
std::string to_csv(const Table& table);

// "none", "participants", "trials".
std::string to_text(Pooling pooling);
std::string to_text(Disposition disposition);

}  // namespace promenade::analysis
