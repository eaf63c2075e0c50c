#include "study/utf8.h"

#include <gtest/gtest.h>

namespace promenade::study {
namespace {

TEST(Utf8, CountsCharactersNotBytes) {
  EXPECT_EQ(count_characters(""), 0);
  EXPECT_EQ(count_characters("aé歩😀"), 4);
}

TEST(Utf8, CutsBetweenCharacters) {
  EXPECT_EQ(first_characters("歩く人", 2), "歩く");
  EXPECT_EQ(first_characters("歩く人", 9), "歩く人");
  EXPECT_EQ(first_characters("歩く人", 0), "");
}

TEST(Utf8, WritesWhatItDrops) {
  std::string text = "x";
  for (const unsigned int code : {0x61U, 0xE9U, 0x6B69U}) append_character(text, code);
  EXPECT_EQ(text, "xaé歩");
  for (const char* left : {"xaé", "xa", "x", "", ""}) {
    drop_last_character(text);
    EXPECT_EQ(text, left);
  }
}

}  // namespace
}  // namespace promenade::study
