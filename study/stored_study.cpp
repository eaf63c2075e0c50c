#include "study/stored_study.h"

#include <algorithm>

#include "study/load_instrument.h"
#include "study/load_study.h"
#include "study/outline.h"
#include "study/sqlite.h"
#include "study/versions.h"

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

// The other parts are texts and sets.
std::optional<Instrument> instrument_in(const StudyPart& part, const Outline& outline) {
  try {
    std::vector<Choice> interfaces;
    for (const std::string& name : outline.interfaces) interfaces.push_back({name, {}});
    return with_interfaces(read_instrument(part.path, part.content).instrument, interfaces);
  } catch (const InputError&) {
    return std::nullopt;
  }
}

Instrument ratings_in(const Outline& outline, const std::string& version) {
  Instrument ratings;
  ratings.name = "rating";
  ratings.version = version;
  for (const std::string& name : outline.ratings) {
    Item item;
    item.name = name;
    ratings.items.push_back(item);
  }
  return ratings;
}

void add_new(Instrument instrument, std::vector<Instrument>& instruments) {
  const bool known =
      std::any_of(instruments.begin(), instruments.end(), [&](const Instrument& one) {
        return one.name == instrument.name && one.version == instrument.version;
      });
  if (!known) instruments.push_back(std::move(instrument));
}

}  // namespace

std::vector<Instrument> stored_instruments(Database& database) {
  std::vector<Instrument> instruments;
  Statement row(database,
                "SELECT uuid, version, config_text FROM study ORDER BY created_utc DESC, uuid");
  while (row.step()) {
    const Outline outline = outline_of(row.text(2));
    for (const StudyPart& part : parts_of(database, row.text(0))) {
      std::optional<Instrument> read = instrument_in(part, outline);
      if (read) add_new(std::move(*read), instruments);
    }
    if (!outline.ratings.empty()) add_new(ratings_in(outline, row.text(1)), instruments);
  }
  return instruments;
}

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

std::optional<StudyBundle> read_newest_study(Database& database,
                                             const InterfaceRegistry& registry) {
  const std::vector<StudyVersion> versions = study_versions(database);
  if (versions.empty()) return std::nullopt;
  try {
    return read_stored_study(database, versions.back().uuid, registry);
  } catch (const InputError&) {
    return std::nullopt;
  }
}

}  // namespace promenade::study
