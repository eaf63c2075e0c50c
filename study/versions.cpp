#include "study/versions.h"

#include <algorithm>

#include "study/sqlite.h"

namespace promenade::study {
namespace {

// Databases of before there were amendments have one version, the newest row.
constexpr const char* query_without_amendments =
    "SELECT uuid, name, version, study_sha256, config_text, program_version, created_utc, NULL, "
    "NULL, NULL, 0 FROM study ORDER BY created_utc, uuid DESC";

bool has_amendments(Database& database) {
  Statement table(database, "SELECT 1 FROM sqlite_schema WHERE name = 'amendment'");
  return table.step();
}

StudyVersion version_in(const Statement& row) {
  return {row.text(0), row.text(1), row.text(2), row.text(3), row.text(4),         row.text(5),
          row.text(6), row.text(7), row.text(8), row.text(9), row.integer(10) != 0};
}

std::string old_version_problem(const StudyVersion& newest) {
  return "holds the study \"" + newest.name + "\" in a newer version, \"" + newest.version +
         "\", since " + newest.amended_utc + " (" + newest.reason +
         "); go on with the file of that version";
}

}  // namespace

// By the number of amendments that lead to them: two may have been made in one second.
const char* const study_versions_query =
    "WITH RECURSIVE chain(uuid, depth) AS ("
    "SELECT uuid, 0 FROM study WHERE uuid NOT IN (SELECT study FROM amendment) "
    "UNION SELECT study, depth + 1 FROM amendment JOIN chain ON previous = chain.uuid) "
    "SELECT study.uuid, name, version, study_sha256, config_text, program_version, created_utc, "
    "previous, reason, amended_utc, coalesce(same_orders, 0) "
    "FROM chain JOIN study ON study.uuid = chain.uuid "
    "LEFT JOIN amendment ON amendment.study = study.uuid "
    "ORDER BY depth, coalesce(amended_utc, created_utc), study.uuid DESC";

std::vector<StudyVersion> study_versions(Database& database) {
  Statement row(database,
                has_amendments(database) ? study_versions_query : query_without_amendments);
  std::vector<StudyVersion> versions;
  while (row.step()) versions.push_back(version_in(row));
  return versions;
}

std::string study_problem(Database& database, const StudyBundle& bundle) {
  const std::vector<StudyVersion> versions = study_versions(database);
  if (versions.empty() || versions.back().sha256 == bundle.sha256) return "";
  const StudyVersion& newest = versions.back();
  const bool older =
      std::any_of(versions.begin(), versions.end(),
                  [&bundle](const StudyVersion& one) { return one.sha256 == bundle.sha256; });
  if (older) return old_version_problem(newest);
  if (newest.name != bundle.study.name) {
    return "holds another study, \"" + newest.name + "\"; name another database for \"" +
           bundle.study.name + "\"";
  }
  return "holds the study \"" + newest.name +
         "\" as it was before its file, its motions or the texts of the program changed; name a "
         "new database for the changed study, or let `promenade amend` make it the next version";
}

}  // namespace promenade::study
