#include "app/participant_code.h"

#include <gtest/gtest.h>

namespace promenade::app {
namespace {

bool is_good(const std::string& code) { return participant_code_problem(code).empty(); }

std::string repeated(int count, const std::string& letter) {
  std::string text;
  for (int k = 0; k < count; ++k) text += letter;
  return text;
}

TEST(ParticipantCode, FortyCharactersOfAnyLanguageAreGood) {
  for (const std::string letter : {"x", "\u00f6", "\u6b69", "\U0001F6B6"}) {
    EXPECT_TRUE(is_good(repeated(1, letter)));
    EXPECT_TRUE(is_good(repeated(40, letter)));
    EXPECT_FALSE(is_good(repeated(41, letter)));
  }
}

TEST(ParticipantCode, NothingIsNoCode) { EXPECT_FALSE(is_good("")); }

TEST(ParticipantCode, ControlCharactersAreRefused) {
  for (const std::string code : {"P\n1", "\x7f", "\u0085", "a\tb", "\x1b[31m"}) {
    EXPECT_FALSE(is_good(code));
  }
  EXPECT_FALSE(is_good(std::string("P\0", 2)));
}

TEST(ParticipantCode, BytesThatAreNoUtf8AreRefused) {
  for (const std::string code : {"\xff", "P\xc3", "\xe6\xad", "\xc0\xaf", "\xed\xa0\x80"}) {
    EXPECT_FALSE(is_good(code));
  }
}

}  // namespace
}  // namespace promenade::app
