// From databases to a folder with report.html, report.json, figures and tables.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "analysis/progress.h"
#include "analysis/selection.h"
#include "study/interface.h"

namespace promenade::analysis {

struct ReportOptions {
  std::vector<std::string> databases;  // at least one
  std::filesystem::path folder;        // made if missing; else its files are replaced
  SelectionOptions selection;
  Progress progress = {};
  // Of the interfaces that the study used, to find what each can reach; null: no regret.
  const study::InterfaceRegistry* registry = nullptr;
  std::string prereg_file = {};  // the registered document; empty: none
};

// What whoever makes a report again has to know: which numbers differ from those of the report
// that stood in the folder. Nothing where there was none, or the same.
using ReportNotes = std::vector<std::string>;

// Everything is computed and drawn before anything appears at `folder`. Throws
// InputError (wrong databases, exclusions or preregistration, no finished trial, `folder` is a
// file) and OutsideError (disk, gnuplot, stopped by `progress`).
ReportNotes write_report(const ReportOptions& options);

}  // namespace promenade::analysis
