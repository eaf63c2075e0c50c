// Every text that a participant sees, by key and language. A language is one
// file, configs/languages/NAME.toml; a test fails on a missing key.
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace promenade::study {

// A text of a study's own, by language; "en" stands in for what is missing.
using LocalText = std::map<std::string, std::string, std::less<>>;
const std::string& text_in(const LocalText& text, std::string_view language);

class Texts {
 public:
  explicit Texts(std::map<std::string, std::string, std::less<>> texts);
  // "trial.match" and the like. An unknown key is a programmer's mistake; the key
  // itself is shown.
  const std::string& operator()(std::string_view key) const;
  // The text, or null.
  const std::string* find(std::string_view key) const;
  // With {name} replaced by values.
  std::string with(std::string_view key,
                   const std::vector<std::pair<std::string, std::string>>& values) const;
  // The name of a style as people read it: "style.NAME", or the name itself with
  // spaces for underscores.
  std::string style(std::string_view name) const;
  std::vector<std::string> keys() const;  // sorted

 private:
  mutable std::map<std::string, std::string, std::less<>> texts_;
};

// "en", "ja": the embedded file of that language. Throws InputError for others.
Texts load_texts(std::string_view language);
// The same under those of `own`, the text of such a file as it was when a study was frozen;
// `file` names it in problems. What it lacks is the program's.
Texts load_texts(std::string_view language, const std::string& file, std::string_view own);
std::vector<std::string> known_languages();

// Several files of texts in one; each with its name, for problems.
Texts parse_texts(const std::vector<std::pair<std::string, std::string_view>>& files);

// Of all languages of a study, by language.
using StudyTexts = std::map<std::string, Texts, std::less<>>;
// Those of the study, else the program's. Throws InputError for a language unknown to both.
Texts texts_in(const StudyTexts& texts, std::string_view language);

}  // namespace promenade::study
