#include "study/stored_study.h"

#include <map>

#include "motion/set_file.h"
#include "study/load_study.h"
#include "study/sqlite.h"

namespace promenade::study {
namespace {

std::map<std::string, std::string> parts_of(Database& database, const std::string& study) {
  std::map<std::string, std::string> parts;
  Statement row(database, "SELECT path, content FROM study_part WHERE study = ?");
  row.bind(1, study);
  while (row.step()) parts[row.text(0)] = std::string(row.blob(1));
  return parts;
}

std::string set_of(Database& database, const std::string& study) {
  Statement row(database,
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
  const std::map<std::string, std::string> parts = parts_of(database, study_uuid);
  const auto part = [&](const std::string& name, const std::string&) {
    const auto found = parts.find(name);
    if (found != parts.end()) return found->second;
    throw InputError(database.file(), "does not hold \"" + name + "\", which the study names");
  };
  const auto set = [&](const std::string&, const std::string&) {
    return motion::from_bytes(set_of(database, study_uuid), database.file());
  };
  StudyBundle bundle = read_study(database.file(), row.text(0), registry, set, part);
  bundle.sha256 = row.text(1);
  return bundle;
}

}  // namespace promenade::study
