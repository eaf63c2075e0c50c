// The seal of a preregistration: [study] prereg = "FILE" names the document, which is part of the
// study like every file that it names, so that its hash is in the database before the first
// session. The document in turn holds the hash of the study file without that line.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "study/study.h"

namespace promenade::study {

class Database;

// The document that a study file names; empty: none.
std::string prereg_file_in(std::string_view config_text);

// The text without the line of `prereg`, if there is one: what the document is about.
std::string without_seal(std::string_view config_text);

// The study without its seal: as it was, or would have been, before the document was written.
// The document need not be there. Throws InputError as load_study does.
StudyBundle load_unsealed_study(const std::string& file, const InterfaceRegistry& registry);

struct Seal {
  std::string file;    // as the study names it
  std::string sha256;  // of the document
};

// Of a version of the study; nothing: it names no document.
std::optional<Seal> seal_in(Database& database, const std::string& study_uuid,
                            std::string_view config_text);

}  // namespace promenade::study
