// From a database to a folder of CSV with its codebook, in the layout of Psych-DS: long
// tables in data/, one row for each person in people_wide.csv.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "analysis/progress.h"
#include "analysis/selection.h"

namespace promenade::study {
class InterfaceRegistry;
}  // namespace promenade::study

namespace promenade::analysis {

struct ExportOptions {
  std::string database;
  std::filesystem::path folder;  // made if missing; else its files of these names are replaced
  SelectionOptions selection;    // who is in people_wide.csv; the tables mark everyone
  bool is_public = false;        // as analysis/export/export_public.h says
  std::string reviewed_file;     // free answers that may be published; empty: none
  bool with_motions = false;     // public: the motions of captures, too
  Progress progress = {};
};

// What whoever exports has to know: who and what was left out, cells that are too small. One
// sentence each; they may name what the folder hides.
using ExportNotes = std::vector<std::string>;

// Reads one state of the database and writes everything, or nothing at all. The same database
// gives the same files, byte for byte, but for the random codes of a public export. Throws
// InputError (no database of Promenade, wrong list of reviewed answers, `folder` is a file)
// and OutsideError (disk, stopped by `progress`).
ExportNotes write_export(const ExportOptions& options, const study::InterfaceRegistry& registry);

}  // namespace promenade::analysis
