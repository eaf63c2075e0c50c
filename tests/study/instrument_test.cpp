#include "study/instrument.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "study/rng.h"

namespace promenade::study {
namespace {

ItemAnswer number(double value) { return {value, "", false}; }
ItemAnswer words(const std::string& text) { return {std::nullopt, text, false}; }
ItemAnswer chosen(double place, const std::string& name) { return {place, name, false}; }
const ItemAnswer declined = {std::nullopt, "", true};

Item item_of(ItemKind kind) {
  Item item;
  item.name = "item";
  item.kind = kind;
  item.choices = {{"a", {}, false}, {"b", {}, false}, {"own", {}, true}};
  return item;
}

TEST(Answers, ToAScaleLieOnItsSteps) {
  Item item = item_of(ItemKind::scale);
  item.least = 0;
  item.most = 100;
  item.step = 5;
  for (const double value : {0.0, 5.0, 100.0}) EXPECT_TRUE(allows(item, number(value))) << value;
  for (const double value : {-5.0, 3.0, 105.0, std::nan("")}) {
    EXPECT_FALSE(allows(item, number(value))) << value;
  }
  EXPECT_FALSE(allows(item, {5.0, "five", false}));
  EXPECT_FALSE(allows(item, words("5")));
}

TEST(Answers, ToANumberLieBetweenItsEnds) {
  Item item = item_of(ItemKind::number);
  item.least = 18;
  item.most = 99;
  EXPECT_TRUE(allows(item, number(18.25)));
  EXPECT_FALSE(allows(item, number(17.9)));
}

TEST(Answers, ToAChoiceAreAPlaceWithItsName) {
  const Item item = item_of(ItemKind::choice);
  EXPECT_TRUE(allows(item, chosen(2, "b")));
  EXPECT_FALSE(allows(item, chosen(1, "b")));
  EXPECT_FALSE(allows(item, chosen(0, "a")));
  EXPECT_FALSE(allows(item, chosen(4, "a")));
  EXPECT_FALSE(allows(item, chosen(1.5, "a")));
  EXPECT_FALSE(allows(item, words("a")));
}

TEST(Answers, ToAFreeChoiceAreItsNameOrOwnWords) {
  Item item = item_of(ItemKind::choice);
  item.longest = 4;
  EXPECT_TRUE(allows(item, chosen(3, "own")));
  EXPECT_TRUE(allows(item, chosen(3, "言葉四つ")));
  EXPECT_FALSE(allows(item, chosen(3, "fives")));
  EXPECT_FALSE(allows(item, chosen(3, "")));
  EXPECT_FALSE(allows(item, chosen(2, "own")));
}

TEST(Answers, ToARankingNameEveryChoiceOnce) {
  const Item item = item_of(ItemKind::ranking);
  EXPECT_TRUE(allows(item, words("own\na\nb")));
  for (const char* text : {"a\nb", "a\nb\nb", "a\nb\nown\n", "a\nb\nc", "a b own"}) {
    EXPECT_FALSE(allows(item, words(text))) << text;
  }
}

TEST(Answers, InFreeWordsAreUpToTheLongestInCharacters) {
  Item item = item_of(ItemKind::text);
  item.longest = 3;
  EXPECT_TRUE(allows(item, words("三文字")));
  EXPECT_FALSE(allows(item, words("four")));
  EXPECT_FALSE(allows(item, number(3)));
}

TEST(Answers, ToABoxAreOne) {
  const Item item = item_of(ItemKind::agree);
  EXPECT_TRUE(allows(item, number(1)));
  EXPECT_FALSE(allows(item, number(0)));
  EXPECT_FALSE(allows(item, {}));
}

TEST(Answers, AreDeclinedOrLeftOutOnlyWhereTheItemSaysSo) {
  for (const ItemKind kind : {ItemKind::scale, ItemKind::choice, ItemKind::number, ItemKind::text,
                              ItemKind::ranking, ItemKind::agree}) {
    Item item = item_of(kind);
    EXPECT_FALSE(allows(item, declined)) << to_text(kind);
    EXPECT_FALSE(allows(item, {})) << to_text(kind);
    item.can_decline = true;
    item.needed = false;
    EXPECT_TRUE(allows(item, declined)) << to_text(kind);
    EXPECT_TRUE(allows(item, {})) << to_text(kind);
    EXPECT_FALSE(allows(item, {1.0, "", true})) << to_text(kind);
  }
}

// Two scales "x" and "y" from 1 to 5, and one choice between their names.
Instrument two_scales() {
  Instrument instrument;
  for (const char* name : {"x", "y"}) {
    Item item = item_of(ItemKind::scale);
    item.name = name;
    item.most = 5;
    instrument.items.push_back(item);
  }
  Item pair = item_of(ItemKind::choice);
  pair.choices = {{"x", {}, false}, {"y", {}, false}};
  pair.pair = true;
  instrument.items.push_back(pair);
  return instrument;
}

ScoreItem part(const std::string& item, bool reversed = false) {
  ScoreItem part;
  part.item = item;
  part.reversed = reversed;
  return part;
}

Score mean_of(const std::vector<ScoreItem>& items) {
  Score score;
  score.items = items;
  return score;
}

Score sum_of(const std::vector<ScoreItem>& items) {
  Score score = mean_of(items);
  score.mean = false;
  return score;
}

Score mean_on(double least, double most, const std::vector<ScoreItem>& items) {
  Score score = mean_of(items);
  score.range = {least, most};
  return score;
}

// Of both scales; each weighs as its name was chosen.
Score weighted_mean() {
  Score score = mean_of({part("x"), part("y")});
  for (ScoreItem& item : score.items) item.weight = item.item;
  return score;
}

std::optional<double> scored(const Score& score, const std::vector<ItemAnswer>& answers) {
  return score_of(two_scales(), score, answers);
}

const std::vector<ItemAnswer> two_and_five = {number(2), number(5), chosen(2, "y")};

TEST(Scores, AreTheMeanOrTheSumOfTheirItems) {
  EXPECT_EQ(scored(mean_of({part("x"), part("y")}), two_and_five), 3.5);
  EXPECT_EQ(scored(sum_of({part("x"), part("y")}), two_and_five), 7.0);
}

TEST(Scores, CountReversedItemsFromTheOtherEnd) {
  EXPECT_EQ(scored(mean_of({part("x", true), part("y")}), two_and_five), 4.5);
  EXPECT_EQ(scored(sum_of({part("x", true), part("y", true)}), two_and_five), 5.0);
}

TEST(Scores, AreBroughtOntoTheirRange) {
  EXPECT_EQ(scored(mean_on(0, 100, {part("x"), part("y")}), two_and_five), 62.5);
  EXPECT_EQ(scored(mean_on(-1, 1, {part("x"), part("y")}), two_and_five), 0.25);
}

TEST(Scores, CountAnItemAsOftenAsItsNameWasChosen) {
  EXPECT_EQ(scored(weighted_mean(), two_and_five), 5.0);
  EXPECT_EQ(scored(weighted_mean(), {number(2), number(5), chosen(1, "x")}), 2.0);
}

TEST(Scores, NeedOnlyTheItemsThatWeigh) {
  EXPECT_EQ(scored(weighted_mean(), {declined, number(5), chosen(2, "y")}), 5.0);
  EXPECT_FALSE(scored(weighted_mean(), {number(2), declined, chosen(2, "y")}));
  EXPECT_FALSE(scored(weighted_mean(), {number(2), number(5), {}}));
  EXPECT_FALSE(scored(mean_of({part("x"), part("y")}), {number(2), {}, {}}));
}

TEST(Scores, HaveARangeOfTheirOwnOrOfTheirItems) {
  const auto range = [](const Score& score) { return score_range(two_scales(), score); };
  EXPECT_EQ(range(mean_of({part("x"), part("y")})).most, 5);
  EXPECT_EQ(range(sum_of({part("x"), part("y")})).most, 10);
  EXPECT_EQ(range(sum_of({part("x"), part("y")})).least, 2);
  EXPECT_EQ(range(mean_on(0, 100, {part("x")})).most, 100);
}

// Three scales, then three pairs.
std::vector<int> order_of(bool shuffled, std::uint64_t participant) {
  Instrument instrument;
  instrument.shuffled = shuffled;
  instrument.items.resize(6);
  for (std::size_t i = 3; i < 6; ++i) instrument.items[i].pair = true;
  Rng rng(1, participant, "items");
  return item_order(instrument, rng);
}

TEST(ItemOrder, ShufflesPairsAlwaysAndItemsWhereTheInstrumentSaysSo) {
  bool items_moved = false;
  bool pairs_moved = false;
  for (std::uint64_t person = 0; person < 20; ++person) {
    const std::vector<int> fixed = order_of(false, person);
    EXPECT_TRUE(std::is_sorted(fixed.begin(), fixed.begin() + 3));
    pairs_moved = pairs_moved || fixed[3] != 3;
    std::vector<int> free = order_of(true, person);
    items_moved = items_moved || free[0] != 0;
    EXPECT_LT(*std::max_element(free.begin(), free.begin() + 3), 3);
    std::sort(free.begin(), free.end());
    EXPECT_EQ(free, (std::vector<int>{0, 1, 2, 3, 4, 5}));
  }
  EXPECT_TRUE(items_moved);
  EXPECT_TRUE(pairs_moved);
}

TEST(Instrument, TakesTheInterfacesOfAStudyAsChoicesWhereAsked) {
  Instrument instrument;
  instrument.items = {item_of(ItemKind::choice), item_of(ItemKind::ranking)};
  instrument.items[1].interfaces = true;
  const std::vector<Choice> interfaces = {{"map", {{"en", "Map"}}, false}};
  const Instrument filled = with_interfaces(instrument, interfaces);
  EXPECT_EQ(filled.items[0].choices.size(), 3U);
  ASSERT_EQ(filled.items[1].choices.size(), 1U);
  EXPECT_EQ(filled.items[1].choices[0].name, "map");
}

}  // namespace
}  // namespace promenade::study
