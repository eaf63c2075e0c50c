#include "app/list_groups.h"

#include <gtest/gtest.h>

namespace promenade::app {
namespace {

motion::MotionSet set_of(const std::vector<std::string>& styles) {
  motion::MotionSet set;
  for (const std::string& style : styles) {
    motion::Cycle cycle;
    cycle.style = style;
    cycle.name = style + "_" + std::to_string(set.size());
    set.cycles.push_back(cycle);
  }
  return set;
}

std::vector<int> groups(const std::vector<std::string>& styles) {
  return style_groups(set_of(styles));
}

TEST(ListGroups, TakeStylesWithOneStemTogether) {
  EXPECT_EQ(groups({"misery-slow", "joy-fast", "misery-fast", "misery"}),
            (std::vector<int>{0, 1, 0, 0}));
}

TEST(ListGroups, TakeNoStylesTogetherForAHyphenAlone) {
  EXPECT_EQ(groups({"on-ice", "hands-in-pockets", "sad"}), (std::vector<int>{0, 1, 2}));
}

TEST(ListGroups, TakeTheCyclesOfAStyleTogether) {
  EXPECT_EQ(groups({"sad", "old", "sad"}), (std::vector<int>{0, 1, 0}));
}

TEST(ListGroups, AreByStyleOnlyWhereThatMakesGroups) {
  EXPECT_EQ(grouping_of("auto", {0, 0, 1, 1}), Grouping::style);
  EXPECT_EQ(grouping_of("auto", {0, 1, 2, 2}), Grouping::none);
  std::vector<int> many;
  for (int k = 0; k < 21; ++k) many.push_back(k);
  EXPECT_EQ(grouping_of("auto", many), Grouping::alphabet);
  EXPECT_EQ(grouping_of("none", {0, 0, 1, 1}), Grouping::none);
}

std::string heading(const std::vector<std::string>& names) {
  std::size_t length = names[0].size();
  for (const std::string& name : names) length = shared_beginning(names[0], length, name);
  return names[0].substr(0, length);
}

TEST(ListGroups, HeadingsEndWithAWord) {
  EXPECT_EQ(heading({"excited, fast", "excited, slow"}), "excited");
  EXPECT_EQ(heading({"long name 100", "long name 101"}), "long name");
  EXPECT_EQ(heading({"興奮・速い", "興奮・遅い"}), "興奮");
  EXPECT_EQ(heading({"happy", "harsh"}), "");
  EXPECT_EQ(heading({"neutral", "neutral, fast"}), "neutral");
}

TEST(ListGroups, RowsAreTheRestOfTheName) {
  EXPECT_EQ(after_heading("excited, fast", 7), "fast");
  EXPECT_EQ(after_heading("興奮・速い", 6), "速い");
  EXPECT_EQ(after_heading("neutral", 7), "neutral");
  EXPECT_EQ(after_heading("sad", 0), "sad");
}

TEST(ListGroups, LettersStandForTheirBeginning) {
  EXPECT_EQ(letter_of("angry"), "A");
  EXPECT_EQ(letter_of("Zebra"), "Z");
  EXPECT_EQ(letter_of("ゴリラ"), "katakana");
  EXPECT_EQ(letter_of("おびえ"), "hiragana");
  EXPECT_EQ(letter_of("興奮"), "kanji");
  EXPECT_EQ(letter_of("élan"), "é");
  EXPECT_EQ(letter_of(""), "");
}

TEST(ListGroups, AFilterIsAPartOfTheName) {
  EXPECT_TRUE(matches("Excited, fast", "excited"));
  EXPECT_TRUE(matches("興奮・速い", "速"));
  EXPECT_TRUE(matches("sad", ""));
  EXPECT_FALSE(matches("sad", "sadder"));
}

}  // namespace
}  // namespace promenade::app
