// analysis.R of an export, with the tables that it reads: the trials, measures and tests of a
// report of the same people.
#pragma once

#include <filesystem>

#include "analysis/export/export_parts.h"
#include "analysis/progress.h"

namespace promenade::analysis {

// Writes analysis.R and tables/. False, and nothing is written, when no trial counts. In a public
// export trials have their public names, and no station. Throws OutsideError (disk, stopped by
// `progress`).
bool write_r_script(const ExportSource& source, const std::filesystem::path& folder,
                    const Progress& progress);

}  // namespace promenade::analysis
