// What the parts of an export share (analysis/export/export.h): what is exported, and what is said
// about each column.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "analysis/columns.h"
#include "analysis/dataset.h"
#include "analysis/questionnaires.h"
#include "study/instrument.h"
#include "study/sqlite.h"

namespace promenade::analysis {

// A column of a file, as the codebook describes it.
struct ExportColumn {
  std::string file;  // "data/description-trial_data.csv"
  std::string column, unit, meaning;
};

struct ExportSource {
  study::Database& database;  // in a public export its tables are views (export_public.h)
  Log log;
  Selection selection;
  // Of all versions of the study; in the order of their files, each once.
  std::vector<study::Instrument> instruments;
  bool is_public = false;
};

// Unit and meaning from table `dictionary`; empty where it says nothing.
ExportColumn described(study::Database& database, std::string_view table, std::string_view column);

// Every table that rows of people stand in comes session by session in this order: people by
// code, each by start. Indices into Log::sessions.
std::vector<int> session_order(const Log& log);
// For each session of the log: is it the one of a person who counts?
std::vector<bool> counting_sessions(const ExportSource& source);

}  // namespace promenade::analysis
