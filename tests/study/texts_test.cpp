#include "study/texts.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "motion/models/adjective_pairs.h"
#include "motion/models/features.h"
#include "motion/problem.h"

namespace promenade::study {
namespace {

TEST(Texts, HaveTheSameKeysInEveryLanguage) {
  const std::vector<std::string> english = load_texts("en").keys();
  EXPECT_GT(english.size(), 50U);
  for (const std::string& language : known_languages()) {
    EXPECT_EQ(load_texts(language).keys(), english) << language;
  }
}

TEST(Texts, AreNeverEmpty) {
  for (const std::string& language : known_languages()) {
    const Texts texts = load_texts(language);
    for (const std::string& key : texts.keys()) EXPECT_FALSE(texts(key).empty()) << key;
  }
}

// The {placeholders} of a text, sorted.
std::vector<std::string> placeholders(const std::string& text) {
  std::vector<std::string> found;
  for (std::size_t at = text.find('{'); at != std::string::npos; at = text.find('{', at + 1)) {
    found.push_back(text.substr(at, text.find('}', at) - at + 1));
  }
  std::sort(found.begin(), found.end());
  return found;
}

TEST(Texts, ReplaceTheSameWordsInEveryLanguage) {
  const Texts english = load_texts("en");
  for (const std::string& language : known_languages()) {
    const Texts texts = load_texts(language);
    for (const std::string& key : english.keys()) {
      EXPECT_EQ(placeholders(texts(key)), placeholders(english(key))) << language << ' ' << key;
    }
  }
}

TEST(Texts, HaveAWordForEveryAdjectiveAndANameForEveryFeature) {
  for (const std::string& language : known_languages()) {
    const Texts texts = load_texts(language);
    for (const motion::AdjectivePair& pair : motion::adjective_pairs) {
      for (const std::string_view word : {pair.left, pair.right}) {
        EXPECT_NE(texts.find("adjective." + std::string(word)), nullptr) << language << word;
      }
    }
    for (const std::string_view feature : motion::feature_names()) {
      EXPECT_NE(texts.find("feature." + std::string(feature)), nullptr) << language << feature;
    }
    for (const char* cluster : {"quickness", "clearness", "activeness", "largeness"}) {
      EXPECT_NE(texts.find("cluster." + std::string(cluster)), nullptr) << language << cluster;
    }
  }
}

TEST(Texts, PutValuesInTheirPlaces) {
  EXPECT_EQ(load_texts("en").with("trial.number", {{"number", "3"}, {"count", "20"}}),
            "Task 3 of 20");
}

TEST(Texts, ShowAnUnknownKeyItself) { EXPECT_EQ(load_texts("en")("no.such"), "no.such"); }

TEST(Texts, NameAStyleOrFallBackOnItsOwnName) {
  const Texts texts = load_texts("ja");
  EXPECT_EQ(texts.style("sad"), "悲しい");
  EXPECT_EQ(texts.style("moon_walk"), "moon walk");
}

TEST(Texts, RefuseAnUnknownLanguageBySayingWhatIsThere) {
  try {
    load_texts("jp");
    FAIL();
  } catch (const InputError& error) {
    EXPECT_STREQ(error.what(),
                 "language \"jp\": error: there are texts in \"en\", \"ja\"; did you mean \"ja\"?");
  }
}

TEST(TextIn, FallsBackOnEnglish) {
  const LocalText text = {{"en", "walk"}, {"ja", "歩く"}};
  EXPECT_EQ(text_in(text, "ja"), "歩く");
  EXPECT_EQ(text_in(text, "fr"), "walk");
  EXPECT_EQ(text_in({{"ja", "歩く"}}, "fr"), "歩く");
  EXPECT_EQ(text_in({}, "en"), "");
}

}  // namespace
}  // namespace promenade::study
