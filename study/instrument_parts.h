// The sections of an instrument's file, each read by one function. Inside study/ only.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "study/instrument.h"
#include "study/study_parts.h"
#include "study/toml_reader.h"

namespace promenade::study {

// Of the ends of scales and scores.
inline constexpr double largest_number = 1e6;

// read_local_text, where a language that is there must not be empty.
LocalText read_words(const TomlTable& table, std::string_view key,
                     const std::vector<std::string>& languages);

// [[item]], then what [pairs] makes.
std::vector<Item> read_items(const TomlTable& root, const std::vector<std::string>& languages);

// [[score]] of the items of `instrument`.
std::vector<Score> read_scores(const TomlTable& root, const Instrument& instrument);

}  // namespace promenade::study
