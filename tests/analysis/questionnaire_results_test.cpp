#include "analysis/questionnaire_results.h"

#include <gtest/gtest.h>

namespace promenade::analysis {
namespace {

study::Item scale(const std::string& name) {
  study::Item item;
  item.name = name;
  item.least = 0;
  item.most = 10;
  return item;
}

study::Item of_kind(study::ItemKind kind, const std::string& name) {
  study::Item item = scale(name);
  item.kind = kind;
  item.choices = {{"map", {}}, {"labels", {}}};
  return item;
}

// Two scales of 0 to 10 with their mean, a choice, a ranking and a text.
study::Instrument load(bool reversed = false) {
  study::Instrument instrument;
  instrument.name = "load";
  instrument.citation = "Somebody, 1999";
  instrument.items = {scale("effort"), scale("time"), of_kind(study::ItemKind::choice, "best"),
                      of_kind(study::ItemKind::ranking, "order"),
                      of_kind(study::ItemKind::text, "why")};
  study::Score score;
  score.name = "all";
  score.items = {{"effort", false, ""}, {"time", reversed, ""}};
  instrument.scores = {score};
  return instrument;
}

using Answers = std::map<std::string, study::ItemAnswer>;

study::ItemAnswer words(const std::string& text) { return {1, text, false}; }

FilledPage page(int person, const std::string& interface, const Answers& answers) {
  return {person, "load", "1", "block", "", interface, "", answers};
}

FilledPage two(int person, const std::string& interface, double effort, double time) {
  return page(person, interface, {{"effort", {effort, "", false}}, {"time", {time, "", false}}});
}

Dataset people(int count) {
  Dataset data;
  data.people.resize(static_cast<std::size_t>(count));
  data.interfaces = {"labels", "map"};
  return data;
}

QuestionnaireResult result(const std::vector<FilledPage>& pages, int count,
                           const study::Instrument& instrument = load()) {
  return questionnaire_results(pages, {instrument}, people(count)).at(0);
}

const ScaleResult& find(const QuestionnaireResult& result, const std::string& name, int interface) {
  for (const ScaleResult& one : result.scales) {
    if (one.name == name && one.interface == interface) return one;
  }
  throw std::runtime_error("no " + name);
}

TEST(QuestionnaireResults, GiveScoresAndItemsOfEachInterface) {
  const auto made =
      result({two(0, "labels", 2, 4), two(0, "map", 6, 8), two(1, "labels", 4, 8)}, 2);
  EXPECT_EQ(*find(made, "all", 0).moments.mean, 4.5);
  EXPECT_EQ(*find(made, "effort", 0).moments.mean, 3);
  EXPECT_EQ(*find(made, "all", 1).moments.mean, 7);
  EXPECT_EQ(find(made, "all", 1).moments.n, 1);
  EXPECT_TRUE(find(made, "all", 0).is_score);
  EXPECT_EQ(made.people, 2);
  EXPECT_EQ(made.pages, 3);
}

TEST(QuestionnaireResults, TakeTheMeanOfWhatAPersonFilledInTwice) {
  const auto made = result({two(0, "map", 2, 2), two(0, "map", 8, 8), two(1, "map", 1, 1)}, 2);
  EXPECT_EQ(find(made, "all", 1).moments.n, 2);
  EXPECT_EQ(*find(made, "all", 1).moments.mean, 3) << "5 and 1, not 2, 8 and 1";
}

// labels - map is 1, ..., 6: p = 2/64, and the middle of the Walsh averages is 3.5.
TEST(QuestionnaireResults, CompareScoresOfInterfaces) {
  std::vector<FilledPage> pages;
  for (int i = 0; i < 6; ++i) {
    pages.push_back(two(i, "map", 1, 1));
    pages.push_back(two(i, "labels", 2 + i, 2 + i));
  }
  const auto made = result(pages, 6);
  ASSERT_EQ(made.pairs.size(), 1u);
  EXPECT_EQ(made.pairs[0].name, "all");
  EXPECT_EQ(*made.pairs[0].comparison.p_holm, 2.0 / 64);
  EXPECT_EQ(*made.pairs[0].comparison.hl, 3.5);
}

// Variances 5/3 and 4/3, of the totals 17/3: alpha = 2 (1 - 3 / (17/3)) = 16/17.
TEST(QuestionnaireResults, KnowHowWellItemsGoTogether) {
  const std::vector<double> effort = {1, 2, 3, 4}, time = {2, 2, 4, 4};
  for (const bool reversed : {false, true}) {
    std::vector<FilledPage> pages;
    for (std::size_t i = 0; i < 4; ++i) {
      pages.push_back(
          two(static_cast<int>(i), "map", effort[i], reversed ? 10 - time[i] : time[i]));
    }
    const auto made = result(pages, 4, load(reversed));
    ASSERT_EQ(made.alphas.size(), 1u);
    EXPECT_EQ(made.alphas[0].interface, 1);
    EXPECT_NEAR(*made.alphas[0].alpha.alpha, 16.0 / 17, 1e-12);
  }
}

TEST(QuestionnaireResults, CountChoicesAndOwnWordsWithoutSayingThem) {
  const auto made =
      result({page(0, "", {{"best", words("map")}}), page(1, "", {{"best", words("map")}}),
              page(2, "", {{"best", words("neither, says Ann")}}),
              page(3, "", {{"best", {{}, "", true}}})},
             4);
  ASSERT_EQ(made.choices.size(), 3u);
  EXPECT_EQ(made.choices[0].choice, "map");
  EXPECT_EQ(made.choices[0].count, 2);
  EXPECT_EQ(made.choices[1].count, 0);
  EXPECT_EQ(made.choices[2].choice, "");
  EXPECT_EQ(made.choices[2].count, 1);
  EXPECT_EQ(made.choices[0].answers, 3);
  EXPECT_EQ(made.declined, 1);
}

TEST(QuestionnaireResults, GiveMeanRanks) {
  const auto ranked = [](int person, double map) {
    return page(person, "",
                {{"order:map", {map, "", false}}, {"order:labels", {3 - map, "", false}}});
  };
  const auto made = result({ranked(0, 1), ranked(1, 1), ranked(2, 2), ranked(3, 1)}, 4);
  ASSERT_EQ(made.ranks.size(), 2u);
  EXPECT_EQ(made.ranks[0].mean_rank, 1.25);
  EXPECT_EQ(made.ranks[0].counts, (std::vector<int>{3, 1}));
  EXPECT_EQ(made.ranks[1].mean_rank, 1.75);
}

TEST(QuestionnaireResults, CountTextsOnly) {
  const auto made =
      result({page(0, "", {{"why", words("because")}}), page(1, "", {{"why", {}}})}, 2);
  ASSERT_EQ(made.texts.size(), 1u);
  EXPECT_EQ(made.texts[0].texts, 1);
}

TEST(QuestionnaireResults, HoldNoNumberThatIsNotFinite) {
  const auto made = result({two(0, "map", 1e308 * 10, 1), two(1, "map", 2, 2)}, 2);
  EXPECT_EQ(find(made, "effort", 1).moments.n, 1);
  EXPECT_EQ(find(made, "all", 1).moments.n, 1);
}

TEST(QuestionnaireResults, OfAnUnknownInstrumentSaySo) {
  const auto made = questionnaire_results({two(0, "map", 1, 2)}, {}, people(1));
  EXPECT_FALSE(made.at(0).is_known);
  EXPECT_TRUE(made.at(0).scales.empty());
}

}  // namespace
}  // namespace promenade::analysis
