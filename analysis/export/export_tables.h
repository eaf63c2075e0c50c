// The tables of a database as tidy CSV, one file each, row by row, so that a log of any size
// fits into memory.
#pragma once

#include <filesystem>
#include <vector>

#include "analysis/export/export_parts.h"
#include "analysis/progress.h"

namespace promenade::analysis {

// "data/description-frameHistogram_data.csv": as Psych-DS names a file of data.
std::string data_file(std::string_view table);

// Writes into `folder` and tells which columns it wrote. Columns of bytes are left out; the
// weights of a sample have one column for each motion. Rows of people begin with the
// column `participant_code` and, where a row can count for the wide table, end with `counts`.
// Throws OutsideError (disk, stopped by `progress`).
std::vector<ExportColumn> export_tables(const ExportSource& source,
                                        const std::filesystem::path& folder,
                                        const Progress& progress);

}  // namespace promenade::analysis
