// The versions of a study in one database: what it was at first, and what each amendment made
// of it. Only the newest one runs.
#pragma once

#include <string>
#include <vector>

#include "study/study.h"

namespace promenade::study {

class Database;

struct StudyVersion {
  std::string uuid, name, version, sha256, config_text, program_version, created_utc;
  // Of its amendment; empty: none, it was the first.
  std::string previous, reason, amended_utc;
  // Every order of the version before is the same order of interfaces in this one, so that
  // who finished it then counts for the balance now.
  bool same_orders = false;
};

// In the order in which they came; empty: no study is in the database yet.
std::vector<StudyVersion> study_versions(Database& database);
// The query behind it, for people who want to repeat it.
extern const char* const study_versions_query;

// Why this study may not run in the database: another study is in it, or another version is
// the newest; empty: it may. Lower case, ends in a way out.
std::string study_problem(Database& database, const StudyBundle& bundle);

}  // namespace promenade::study
