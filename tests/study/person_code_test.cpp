#include "study/person_code.h"

#include <gtest/gtest.h>

#include <set>

namespace promenade::study {
namespace {

// Every code there is, with every single wrong character and every swap of neighbours.
TEST(PersonCode, SeesEverySingleTypoAndEverySwapOfNeighbours) {
  const std::string_view letters = code_characters;
  const auto n = letters.size();
  int codes = 0;
  int missed = 0;
  std::string code(code_length, ' ');
  for (std::size_t i = 0; i < n * n * n * n; ++i) {
    std::size_t rest = i;
    for (int k = 0; k < code_length - 1; ++k, rest /= n) {
      code[static_cast<std::size_t>(k)] = letters[rest % n];
    }
    for (const char check : letters) {
      code.back() = check;
      if (is_person_code(code)) break;
    }
    codes += is_person_code(code);
    for (std::size_t k = 0; k < code.size(); ++k) {
      std::string typed = code;
      for (const char letter : letters) {
        typed[k] = letter;
        missed += letter != code[k] && is_person_code(typed);
      }
      typed = code;
      if (k > 0) std::swap(typed[k - 1], typed[k]);
      missed += typed != code && is_person_code(typed);
    }
  }
  EXPECT_EQ(codes, 707'281);  // 29^4: one check for each
  EXPECT_EQ(missed, 0);
}

TEST(PersonCode, HasNoCharacterThatLooksLikeAnotherAndNoVowel) {
  EXPECT_EQ(code_characters.find_first_of("01IOAEU"), std::string_view::npos);
  EXPECT_EQ(std::set<char>(code_characters.begin(), code_characters.end()).size(), 29U);
}

TEST(PersonCode, RefusesOtherLengthsAndCharacters) {
  Rng rng(1, 0, "roster");
  const std::string code = draw_person_code(rng);
  EXPECT_TRUE(is_person_code(code));
  for (const std::string& wrong : {std::string(), code.substr(1), code + "2", "0" + code.substr(1),
                                   std::string("\xC3\x9F") + code.substr(2)}) {
    EXPECT_FALSE(is_person_code(wrong)) << wrong;
  }
}

TEST(PersonCode, IsReadAsItIsTyped) {
  EXPECT_EQ(tidy_code(" k7q-x3"), "K7QX3");
  EXPECT_EQ(tidy_code("\xC3\xA4"), "\xC3\xA4");
}

TEST(PersonCode, TellsWhichWasMeant) {
  const std::vector<std::string> codes = {"K7QX3", "BBBBB"};
  EXPECT_EQ(meant_code("k7qx4", codes), "K7QX3");
  EXPECT_EQ(meant_code("K7XQ3", codes), "K7QX3");
  EXPECT_EQ(meant_code("K7Q3", codes), "K7QX3");
  EXPECT_EQ(meant_code("K7Q", codes), "");
  EXPECT_EQ(meant_code("K7QX2", {"K7QX3", "K7QX4"}), "");
}

}  // namespace
}  // namespace promenade::study
