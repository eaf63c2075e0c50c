#include "motion/decimal.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <cstring>

#include "tests/motion/models/random.h"

namespace promenade::motion {
namespace {

bool same_bits(double a, double b) { return std::memcmp(&a, &b, sizeof a) == 0; }

// Digits with a point somewhere, perhaps a sign and an exponent.
std::string random_number(Random& random) {
  const auto below = [&](int limit) { return static_cast<int>(random.uniform() * limit); };
  std::string text = below(2) == 0 ? "-" : "";
  const int digits = 1 + below(20);
  const int point = below(digits + 3);
  for (int d = 0; d < digits; ++d) {
    if (d == point) text += '.';
    text += static_cast<char>('0' + below(10));
  }
  if (below(3) == 0) {
    constexpr const char* marks[] = {"e", "E", "e+", "e-", "e-0", "e+00"};
    text += marks[below(6)] + std::to_string(below(below(2) == 0 ? 30 : 330));
  }
  return text;
}

// What a run of numbers takes from the text, at its end and before other text.
void expect_run(const std::string& text, double expected) {
  for (const char* behind : {"", " ", "\n", " 12345678901"}) {
    const std::string line = text + behind;
    double value = -1;
    const DecimalRun run = read_decimals(line.data(), line.data() + line.size(), &value, 1);
    ASSERT_EQ(run.count, 1U) << text;
    ASSERT_EQ(run.end - line.data(), static_cast<std::ptrdiff_t>(text.size())) << text;
    ASSERT_TRUE(same_bits(value, expected)) << text;
  }
}

// strtod of the C locale is correctly rounded in the C library.
TEST(Decimal, IsTheDoubleOfTheCLibraryForAMillionNumbers) {
  Random random(1);
  for (int i = 0; i < 1'000'000; ++i) {
    const std::string text = random_number(random);
    const double expected = std::strtod(text.c_str(), nullptr);
    const ScannedNumber number = to_number(text);
    if (std::isinf(expected)) {
      ASSERT_NE(number.trouble, nullptr) << text;
      continue;
    }
    ASSERT_EQ(number.trouble, nullptr) << text << " " << number.trouble;
    ASSERT_TRUE(same_bits(number.value, expected)) << text;
    if (std::fpclassify(expected) == FP_NORMAL) expect_run(text, expected);
  }
}

TEST(Decimal, RunsStopAtTheEndOfTheLineAndBeforeOtherWords) {
  const std::pair<const char*, std::size_t> table[] = {
      {"1 2.5\t-3e2 \n4", 3}, {"1 2x 3", 1}, {"1 nan 3", 1},
      {"1 1e999", 1},         {"1 +2", 1},   {"1 .", 1},
      {"1 - 2", 1},           {"", 0},       {"\n1", 0},
      {"1 2\r\n3", 2},        {"1 2,5", 1},  {"1 0x10", 1},
      {"1 1.2.3", 1},         {"1 2e", 1},   {"1 --2", 1}};
  for (const auto& [text, count] : table) {
    double values[8];
    const std::string_view line = text;
    EXPECT_EQ(read_decimals(line.data(), line.data() + line.size(), values, 8).count, count)
        << text;
  }
}

TEST(Decimal, TakesWhatWritersOfCapturesWrite) {
  const std::pair<const char*, double> table[] = {
      {"0", 0},          {"-0", -0.0},
      {"+5", 5},         {".5", 0.5},
      {"-.5", -0.5},     {"5.", 5},
      {"1e+009", 1e9},   {"7.62852e-016", 7.62852e-16},
      {"1E-05", 1e-5},   {"1e22", 1e22},
      {"1e23", 1e23},    {"9007199254740993", 9007199254740992.0},
      {"0.1", 0.1},      {"1e-400", 0},
      {"-1e-400", -0.0}, {"123456789012345678901234567890", 123456789012345678901234567890.0}};
  for (const auto& [text, value] : table) {
    EXPECT_EQ(to_number(text).trouble, nullptr) << text;
    EXPECT_TRUE(same_bits(to_number(text).value, value)) << text;
  }
}

TEST(Decimal, RefusesWithAReason) {
  const std::pair<const char*, const char*> table[] = {
      {"", "is not a number"},       {"-", "is not a number"},
      {".", "is not a number"},      {"e5", "is not a number"},
      {"1e", "is not a number"},     {"1e+", "is not a number"},
      {"0x10", "is not a number"},   {"1.2.3", "is not a number"},
      {"--1", "is not a number"},    {"+-1", "is not a number"},
      {"1_000", "is not a number"},  {"1.#QNAN", "is not a number"},
      {"nan", "is not finite"},      {"-inf", "is not finite"},
      {"infinity", "is not finite"}, {"1e400", "is too large"},
      {"-1e309", "is too large"},    {"0,5", "is not a number; decimals want a point"}};
  for (const auto& [text, trouble] : table) EXPECT_STREQ(to_number(text).trouble, trouble) << text;
}

// An exponent may make up for many zeros.
TEST(Decimal, TellsTooLargeFromTooSmall) {
  const std::string zeros(400, '0');
  EXPECT_EQ(to_number("0." + zeros + "1").trouble, nullptr);
  EXPECT_EQ(to_number("0." + zeros + "1").value, 0);
  EXPECT_STREQ(to_number("1" + zeros).trouble, "is too large");
  EXPECT_STREQ(to_number("1" + zeros + "e-5").trouble, "is too large");
  EXPECT_EQ(to_number("1" + zeros + "e-400").value, 1);
  EXPECT_EQ(to_number("0." + zeros + "1e+5").trouble, nullptr);
  EXPECT_STREQ(to_number("1e99999999999999999999").trouble, "is too large");
  EXPECT_EQ(to_number("1e-99999999999999999999").trouble, nullptr);
}

}  // namespace
}  // namespace promenade::motion
