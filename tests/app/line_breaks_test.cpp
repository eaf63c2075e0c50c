#include "app/line_breaks.h"

#include <gtest/gtest.h>

namespace promenade::app {
namespace {

// Every byte of Latin is 1 wide, every Japanese character (three bytes) 2.
float cells(std::string_view text) {
  float width = 0;
  for (const char byte : text) {
    const auto b = static_cast<unsigned char>(byte);
    width += b < 0x80 ? 1 : b >= 0xC0 ? 2 : 0;
  }
  return width;
}

std::vector<std::string_view> lines(std::string_view text, float width) {
  return break_lines(text, width, cells);
}

using Lines = std::vector<std::string_view>;

TEST(LineBreaks, BreaksAtSpacesAndDropsThem) {
  EXPECT_EQ(lines("one two three", 7), (Lines{"one two", "three"}));
}

TEST(LineBreaks, KeepsEmptyLinesBetweenParagraphs) {
  EXPECT_EQ(lines("one\n\ntwo", 9), (Lines{"one", "", "two"}));
}

TEST(LineBreaks, AWordThatIsTooWideHasItsOwnLine) {
  EXPECT_EQ(lines("a wonderful b", 4), (Lines{"a", "wonderful", "b"}));
}

TEST(LineBreaks, JapaneseBreaksBetweenCharacters) {
  EXPECT_EQ(lines("歩き方を選ぶ", 6), (Lines{"歩き方", "を選ぶ"}));
}

TEST(LineBreaks, NoLineBeginsWithAFullStop) {
  EXPECT_EQ(lines("歩く人。次", 6), (Lines{"歩く", "人。次"}));
}

TEST(LineBreaks, NoLineEndsWithAnOpeningBracket) {
  EXPECT_EQ(lines("歩く「人」", 6), (Lines{"歩く", "「人」"}));
}

TEST(LineBreaks, NothingIsLost) {
  const std::string text = "参加は任意です。 You may stop（いつでも）。\n\n次へ";
  for (float width = 1; width < 60; ++width) {
    std::string joined;
    for (const std::string_view line : lines(text, width)) joined += line;
    std::string plain;
    for (const char c : text) {
      if (c != ' ' && c != '\n') plain += c;
    }
    joined.erase(std::remove(joined.begin(), joined.end(), ' '), joined.end());
    EXPECT_EQ(joined, plain) << width;
  }
}

}  // namespace
}  // namespace promenade::app
