#include "study/stored_study.h"

#include "study/load_study.h"
#include "study/sqlite.h"

namespace promenade::study {
namespace {

std::vector<StudyPart> parts_of(Database& database, const std::string& study) {
  std::vector<StudyPart> parts;
  Statement row(database, "SELECT path, content FROM study_part WHERE study = ? ORDER BY path");
  row.bind(1, study);
  while (row.step()) parts.push_back({row.text(0), std::string(row.blob(1))});
  return parts;
}

std::string set_of(Database& database, const std::string& study) {
  Statement row(
      database,
      "SELECT content FROM motion_set WHERE uuid = coalesce((SELECT motion_set FROM study "
      "WHERE uuid = ?), uuid) LIMIT 1");
  if (!row.bind(1, study).step()) {
    throw InputError(database.file(), "does not hold the motions of the study");
  }
  return std::string(row.blob(0));
}

}  // namespace

StudyBundle read_stored_study(Database& database, const std::string& study_uuid,
                              const InterfaceRegistry& registry) {
  Statement row(database, "SELECT config_text, study_sha256 FROM study WHERE uuid = ?");
  if (!row.bind(1, study_uuid).step()) {
    throw InputError(database.file(), "has no study " + study_uuid);
  }
  const FrozenStudy frozen{row.text(0), set_of(database, study_uuid),
                           parts_of(database, study_uuid)};
  StudyBundle bundle = read_frozen_study(database.file(), frozen, registry);
  bundle.sha256 = row.text(1);
  return bundle;
}

}  // namespace promenade::study
