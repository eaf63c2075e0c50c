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

TEST(Utf8, ReadsCharactersOfTheBasicPlane) {
  for (const auto& [text, code] : {std::pair{"a", 0x61U}, {"é", 0xE9U}, {"歩", 0x6B69U}}) {
    EXPECT_EQ(first_character(text).code, code);
    EXPECT_EQ(first_character(text).bytes, std::string_view(text).size());
  }
  EXPECT_EQ(first_character("😀").code, 0U);
  EXPECT_EQ(first_character("😀").bytes, 4U);
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
