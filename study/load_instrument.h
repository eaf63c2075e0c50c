// Instruments as files: those that come with the program, and those of a study's own.
// docs/instruments.md describes the format.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "motion/problem.h"
#include "study/instrument.h"

namespace promenade::study {

struct InstrumentFile {
  Instrument instrument;
  std::string text;               // letter by letter: part of what a study is
  std::vector<Problem> warnings;  // texts that a language lacks
};

// Reads an instrument that is shown in these languages. Throws InputError with all problems
// and their places.
InstrumentFile read_instrument(const std::string& file, std::string_view text,
                               const std::vector<std::string>& languages = known_languages());

// "sus" and the like are those of the program; "own.toml" is a file, relative to `folder`.
// Throws InputError, also for a name that does not exist.
InstrumentFile load_instrument(const std::string& name, const std::string& folder,
                               const std::vector<std::string>& languages = known_languages());

std::vector<std::string> known_instruments();  // sorted
std::optional<std::string_view> embedded_instrument(std::string_view name);

}  // namespace promenade::study
