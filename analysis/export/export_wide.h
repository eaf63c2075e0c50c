// One row for each person who counts, one column for each thing that was measured or asked
// of them: for JASP and every program that wants it so. And the same as one row per value.
#pragma once

#include <string>
#include <vector>

#include "analysis/export/export_parts.h"

namespace promenade::analysis {

// `measure[.task][.interface][.target]`; of an answer `instrument.item`, of a score
// `instrument.score`, where an instrument is asked at several moments followed by the moment.
struct WideColumn {
  std::string name;
  std::string measure, task, interface, target;  // empty: over all, or none
  std::string unit, meaning;
  std::vector<std::string> cells;  // one for each person; empty: no value
};

struct WideTable {
  std::vector<std::string> people;  // codes
  std::vector<bool> simulated, pilot;
  std::vector<WideColumn> columns;
};

// Values of trials are means: over targets, and of each target. Practice, and what was
// done again, does not count.
WideTable make_wide(const ExportSource& source);

std::string wide_csv(const WideTable& table);
std::string long_csv(const WideTable& table);

// What the codebook says of the two files.
std::vector<ExportColumn> wide_codebook(const WideTable& table, const std::string& wide_file,
                                        const std::string& long_file);

}  // namespace promenade::analysis
