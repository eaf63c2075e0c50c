// The desk speaks every language in full.
#include "app/desk/words.h"

#include <gtest/gtest.h>

#include <set>

namespace promenade::app {
namespace {

// {name}, {count}: what is replaced while the program runs.
std::set<std::string> places_in(const std::string& text) {
  std::set<std::string> places;
  for (std::size_t at = text.find('{'); at != std::string::npos; at = text.find('{', at + 1)) {
    places.insert(text.substr(at, text.find('}', at) - at));
  }
  return places;
}

TEST(DeskWords, HaveTheSameKeysAndPlacesInEveryLanguage) {
  const study::Texts english = desk_texts("en");
  for (const std::string& language : desk_languages()) {
    const study::Texts texts = desk_texts(language);
    EXPECT_EQ(texts.keys(), english.keys()) << language;
    for (const std::string& key : english.keys()) {
      EXPECT_EQ(places_in(texts(key)), places_in(english(key))) << language << ": " << key;
    }
  }
}

TEST(DeskWords, AreNoPartOfWhatParticipantsRead) {
  EXPECT_EQ(study::load_texts("en").find("shell.studies"), nullptr);
}

}  // namespace
}  // namespace promenade::app
