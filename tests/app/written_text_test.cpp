#include "app/written_text.h"

#include <gtest/gtest.h>

namespace promenade::app {
namespace {

// Ten letters in a line; a letter of another script counts for two.
WrittenText made(const std::string& words) {
  WrittenText text;
  text.fit(10, [](std::string_view part) {
    float width = 0;
    for (const char byte : part) width += static_cast<unsigned char>(byte) < 0x80 ? 1 : 2.0f / 3;
    return width;
  });
  text.set(words);
  return text;
}

// What the field gives back when `typed` was put in at a place of what is shown.
std::size_t put(WrittenText& text, std::size_t at, const std::string& typed) {
  text.stand_at(at);
  std::string now = text.shown();
  now.insert(at, typed);
  return text.edited(now, at + typed.size(), 1000);
}

// The key deletes the character in front of the caret.
std::size_t backspace(WrittenText& text, std::size_t at) {
  text.stand_at(at);
  std::string now = text.shown();
  now.erase(at - 1, 1);
  return text.edited(now, at - 1, 1000);
}

TEST(WrittenText, BreaksLinesThatAreNoneOfTheWords) {
  const WrittenText text = made("one two three four");
  EXPECT_EQ(text.words(), "one two three four");
  EXPECT_EQ(text.shown(), "one two \nthree four");
}

TEST(WrittenText, KeepsTheLineEndsThatWereTyped) {
  WrittenText text = made("one two three");
  put(text, 3, "\n");
  EXPECT_EQ(text.words(), "one\n two three");
  EXPECT_EQ(text.shown(), "one\n two three");
}

TEST(WrittenText, TakesItsOwnLineEndsOutOfWhatComesBack) {
  WrittenText text = made("one two three four");
  const std::size_t caret = put(text, text.shown().size(), "teen");
  EXPECT_EQ(caret, text.shown().size());
  EXPECT_EQ(text.words(), "one two three fourteen");
  EXPECT_EQ(text.shown(), "one two \nthree \nfourteen");
}

TEST(WrittenText, LeavesTheCaretBehindWhatWasTyped) {
  WrittenText text = made("one two three four");
  const std::size_t caret = put(text, 3, "ly");
  EXPECT_EQ(text.words(), "onely two three four");
  EXPECT_EQ(caret, 5U);
  EXPECT_EQ(put(text, 11, "x"), 12U) << "in front of the second line";
  EXPECT_EQ(text.words(), "onely two xthree four");
}

TEST(WrittenText, BackspaceAtTheHeadOfALineMeansTheCharacterBefore) {
  WrittenText text = made("one two three four");
  backspace(text, 9);
  EXPECT_EQ(text.words(), "one twothree four");
}

TEST(WrittenText, DeleteAtTheEndOfALineMeansTheCharacterBehind) {
  WrittenText text = made("one two three four");
  text.stand_at(8);
  std::string now = text.shown();
  now.erase(8, 1);
  EXPECT_EQ(text.edited(now, 8, 1000), 9U);
  EXPECT_EQ(text.words(), "one two hree four");
}

TEST(WrittenText, DeletesASelectionOverSeveralLines) {
  WrittenText text = made("one two three four");
  text.stand_at(14);
  EXPECT_EQ(text.edited("one  four", 4, 1000), 4U);
  EXPECT_EQ(text.words(), "one  four");
}

TEST(WrittenText, BreaksJapaneseBetweenCharacters) {
  WrittenText text = made("");
  put(text, 0, "歩き方がとても自然");
  EXPECT_EQ(text.words(), "歩き方がとても自然");
  EXPECT_EQ(text.shown(), "歩き方がと\nても自然");
  backspace(text, 16);
  EXPECT_EQ(text.words(), "歩き方がても自然");
}

TEST(WrittenText, KeepsNoMoreThanIsAllowed) {
  WrittenText text = made("");
  EXPECT_EQ(text.edited("歩き方がとても自然", 27, 4), 12U);
  EXPECT_EQ(text.words(), "歩き方が");
}

// Whatever is done to what is shown, it is the same as if the words had been in one line.
TEST(WrittenText, EqualsAFieldWithoutLineEndsForAnyTyping) {
  WrittenText text = made("");
  std::string plain;
  for (std::size_t k = 0; k < 400; ++k) {
    const std::size_t at = (k * 7919) % (plain.size() + 1);
    const std::string typed(1, k % 5 == 0 ? ' ' : static_cast<char>('a' + k % 26));
    std::size_t shown = 0;  // the same place
    for (std::size_t words = 0; words < at; ++shown) {
      const bool added = text.shown()[shown] == '\n';
      words += added ? 0 : 1;
    }
    put(text, shown, typed);
    plain.insert(at, typed);
    ASSERT_EQ(text.words(), plain) << k;
  }
}

}  // namespace
}  // namespace promenade::app
