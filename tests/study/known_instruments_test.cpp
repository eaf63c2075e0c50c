// The instruments that come with the program: complete in every language, and scored as
// their authors say.
#include <gtest/gtest.h>

#include <algorithm>
#include <map>

#include "motion/models/adjective_pairs.h"
#include "study/load_instrument.h"

namespace promenade::study {
namespace {

Instrument known(const std::string& name) { return load_instrument(name, "").instrument; }

TEST(KnownInstruments, AreTheOnesOfTheManual) {
  EXPECT_EQ(known_instruments(),
            (std::vector<std::string>{"adjectives", "comment", "consent", "csi", "demographics",
                                      "experience", "impression", "nasa-tlx", "nasa-tlx-raw",
                                      "preference", "ranking", "satisfaction", "sus", "ueq-s",
                                      "umux-lite"}));
}

TEST(KnownInstruments, AskThePairsOfTheSourceInItsOrder) {
  const Instrument adjectives = known("adjectives");
  ASSERT_EQ(adjectives.items.size(), motion::adjective_pairs.size());
  for (std::size_t i = 0; i < adjectives.items.size(); ++i) {
    const motion::AdjectivePair& pair = motion::adjective_pairs[i];
    const Item& item = adjectives.items[i];
    EXPECT_EQ(motion::find_adjective_pair(item.name), static_cast<int>(i)) << item.name;
    EXPECT_EQ(text_in(item.low, "en"), pair.left);
    EXPECT_EQ(text_in(item.high, "en"), pair.right);
  }
}

TEST(KnownInstruments, AreNamedAsTheirFilesAndSayWhereTheyComeFrom) {
  for (const std::string& name : known_instruments()) {
    const Instrument instrument = known(name);
    EXPECT_EQ(instrument.name, name);
    EXPECT_FALSE(instrument.citation.empty()) << name;
    EXPECT_FALSE(instrument.terms.empty()) << name;
    EXPECT_EQ(instrument.translations.rfind("ja: by Promenade", 0), 0U) << name;
  }
}

// Every text of an instrument, by where it stands.
std::map<std::string, LocalText> all_texts(const Instrument& instrument) {
  std::map<std::string, LocalText> texts = {{"title", instrument.title}, {"text", instrument.text}};
  for (const Item& item : instrument.items) {
    texts[item.name + ".question"] = item.question;
    texts[item.name + ".low"] = item.low;
    texts[item.name + ".high"] = item.high;
    for (const Choice& choice : item.choices) texts[item.name + "." + choice.name] = choice.text;
  }
  return texts;
}

TEST(KnownInstruments, HaveEveryTextInEveryLanguage) {
  for (const std::string& name : known_instruments()) {
    EXPECT_TRUE(load_instrument(name, "").warnings.empty()) << name;
    for (const auto& [where, text] : all_texts(known(name))) {
      for (const std::string& language : known_languages()) {
        if (text.empty()) continue;  // in no language
        EXPECT_TRUE(text.count(language) > 0 && !text.find(language)->second.empty())
            << name << ' ' << where << ' ' << language;
      }
    }
  }
}

TEST(KnownInstruments, AskNobodyForANameAndLetPeopleDeclineWhatIsPersonal) {
  for (const Item& item : known("demographics").items) {
    EXPECT_EQ(item.kind, ItemKind::choice) << item.name;
    EXPECT_TRUE(item.can_decline) << item.name;
  }
}

const Score& score_named(const Instrument& instrument, const std::string& name) {
  const auto found = std::find_if(instrument.scores.begin(), instrument.scores.end(),
                                  [&](const Score& score) { return score.name == name; });
  EXPECT_NE(found, instrument.scores.end()) << name;
  return *found;
}

// Scales by their values in the order of the file; of each pair the name that comes first in
// `order` is chosen.
std::vector<ItemAnswer> answers_of(const Instrument& instrument, const std::vector<double>& values,
                                   const std::vector<std::string>& order = {}) {
  std::vector<ItemAnswer> answers;
  const auto rank = [&](const Choice& choice) {
    return std::find(order.begin(), order.end(), choice.name);
  };
  for (const Item& item : instrument.items) {
    if (item.kind == ItemKind::scale) {
      answers.push_back({values.at(answers.size()), "", false});
    } else {
      const bool first = rank(item.choices[0]) < rank(item.choices[1]);
      answers.push_back({first ? 1.0 : 2.0, item.choices[first ? 0 : 1].name, false});
    }
    EXPECT_TRUE(allows(item, answers.back())) << item.name;
  }
  return answers;
}

double scored(const std::string& name, const std::string& score, const std::vector<double>& values,
              const std::vector<std::string>& order = {}) {
  const Instrument instrument = known(name);
  return score_of(instrument, score_named(instrument, score), answers_of(instrument, values, order))
      .value_or(-1000);
}

TEST(Sus, IsScoredAsBrookeDoes) {
  EXPECT_EQ(scored("sus", "sus", std::vector<double>(10, 3)), 50);
  EXPECT_EQ(scored("sus", "sus", {5, 1, 5, 1, 5, 1, 5, 1, 5, 1}), 100);
  EXPECT_EQ(scored("sus", "sus", {1, 5, 1, 5, 1, 5, 1, 5, 1, 5}), 0);
  // The worked example of the paper: 22 points, times 2.5.
  EXPECT_EQ(scored("sus", "sus", {5, 4, 2, 1, 2, 3, 2, 4, 5, 2}), 55);
}

TEST(UmuxLite, GoesFromNoneToAHundred) {
  EXPECT_EQ(scored("umux-lite", "umux-lite", {7, 7}), 100);
  EXPECT_EQ(scored("umux-lite", "umux-lite", {1, 1}), 0);
  EXPECT_EQ(scored("umux-lite", "umux-lite", {6, 5}), 75);  // (6 + 5 - 2) / 12
}

TEST(UeqS, HasTwoQualitiesAndTheirMean) {
  const std::vector<double> values = {3, 2, 1, 0, -1, -2, -3, 0};
  EXPECT_EQ(scored("ueq-s", "pragmatic", values), 1.5);
  EXPECT_EQ(scored("ueq-s", "hedonic", values), -1.5);
  EXPECT_EQ(scored("ueq-s", "overall", values), 0);
  EXPECT_EQ(scored("ueq-s", "overall", std::vector<double>(8, 3)), 3);
}

const std::vector<double> loads = {70, 5, 40, 30, 60, 35};

TEST(NasaTlx, WithoutWeightsIsTheMean) {
  EXPECT_EQ(scored("nasa-tlx-raw", "raw", loads), 40);
  const std::vector<std::string> any = {"effort"};
  EXPECT_EQ(scored("nasa-tlx", "raw", loads, any), 40);
}

// The order gives the weights 5, 4, 3, 2, 1, 0 of mental, effort, frustration, temporal,
// performance and physical: 350 + 240 + 105 + 80 + 30 = 805, by 15.
TEST(NasaTlx, WeighsEachScaleByItsPairs) {
  const std::vector<std::string> order = {"mental",   "effort",      "frustration",
                                          "temporal", "performance", "physical"};
  EXPECT_EQ(scored("nasa-tlx", "weighted", loads, order), 805.0 / 15);
  EXPECT_EQ(scored("nasa-tlx", "weighted", std::vector<double>(6, 100), order), 100);
}

TEST(NasaTlx, HasNoWeightedScoreWithoutEveryPair) {
  const Instrument tlx = known("nasa-tlx");
  const Score& weighted = score_named(tlx, "weighted");
  std::vector<ItemAnswer> answers = answers_of(tlx, loads);
  EXPECT_TRUE(score_of(tlx, weighted, answers));
  answers.back() = {};
  EXPECT_FALSE(score_of(tlx, weighted, answers));
  EXPECT_TRUE(score_of(tlx, score_named(tlx, "raw"), answers));
}

TEST(NasaTlx, HasFifteenPairsAndTwentyOneSteps) {
  const Instrument tlx = known("nasa-tlx");
  EXPECT_EQ(std::count_if(tlx.items.begin(), tlx.items.end(), [](const Item& i) { return i.pair; }),
            15);
  EXPECT_EQ((tlx.items[0].most - tlx.items[0].least) / tlx.items[0].step + 1, 21);
}

const std::vector<std::string> factors = {"exploration", "enjoyment",      "results",
                                          "immersion",   "expressiveness", "collaboration"};

TEST(Csi, GoesFromNoneToAHundred) {
  EXPECT_EQ(scored("csi", "csi", std::vector<double>(12, 10), factors), 100);
  EXPECT_EQ(scored("csi", "csi", std::vector<double>(12, 0), factors), 0);
}

// Sums by factor: collaboration 0, enjoyment 15, exploration 18, expressiveness 11, immersion 9,
// results 14, with the weights 0, 4, 5, 1, 2, 3: 60 + 90 + 11 + 18 + 42 = 221, by 3.
TEST(Csi, WeighsEachFactorByItsPairs) {
  const std::vector<double> values = {0, 0, 8, 7, 9, 9, 5, 6, 4, 5, 7, 7};
  EXPECT_EQ(scored("csi", "csi", values, factors), 221.0 / 3);
  EXPECT_EQ(scored("csi", "exploration", values, factors), 18);
  EXPECT_EQ(scored("csi", "results", values, factors), 14);
}

TEST(KnownInstruments, AskForTheInterfacesOfTheStudyWhereTheyCompareThem) {
  EXPECT_TRUE(find_item(known("preference"), "preferred")->interfaces);
  EXPECT_TRUE(find_item(known("ranking"), "order")->interfaces);
}

}  // namespace
}  // namespace promenade::study
