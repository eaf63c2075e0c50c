// Decimal numbers out of text: nearest double, whatever the locale.
#pragma once

#include <string_view>

namespace promenade::motion {

// The number that [first, last) begins with, correctly rounded, and where it ends; or
// first, when it needs a closer look (no number, very long, very large, very small).
// Takes what captures hold: a sign, up to 19 digits with a point, an exponent.
struct Decimal {
  double value = 0;
  const char* end = nullptr;
};
Decimal read_decimal(const char* first, const char* last);

// What a whole word says as a number.
struct ScannedNumber {
  double value = 0;
  const char* trouble = nullptr;  // why it is none, as a part of a sentence
};
ScannedNumber to_number(std::string_view word);

}  // namespace promenade::motion
