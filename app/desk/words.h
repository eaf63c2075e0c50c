// The texts of the desk: configs/desk/PAGE.LANGUAGE.toml, one file for each page and language. They
// are no part of a study, so that a better word at the desk leaves a study's hash as it is.
#pragma once

#include <string_view>
#include <vector>

#include "study/texts.h"

namespace promenade::app {

// "en", "ja".
std::vector<std::string> desk_languages();

// All pages in one, by key: "studies.new". Throws InputError for a language that is not there.
study::Texts desk_texts(std::string_view language);

// Every text of every language, for the characters of the fonts.
std::vector<std::string> all_desk_words();

}  // namespace promenade::app
