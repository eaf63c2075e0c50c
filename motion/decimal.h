// Decimal numbers out of text, the nearest double, and into it, whatever the locale.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace promenade::motion {

// What a whole word says as a number.
struct ScannedNumber {
  double value = 0;
  const char* trouble = nullptr;  // why it is none, as a part of a sentence
};
ScannedNumber to_number(std::string_view word);

// A run of numbers with blanks between them, within a line.
struct DecimalRun {
  std::size_t count = 0;
  const char* last_number = nullptr;  // where the last one begins; null without one
  const char* end = nullptr;          // behind it, or at the word that stopped the run
};

// Takes numbers from [first, last), at most so many, into `out` (nowhere if null). Stops at
// the end of the line and before a word that is no plain finite number.
DecimalRun read_decimals(const char* first, const char* last, double* out, std::size_t most);

// For people: 0.0586 with three significant digits.
std::string short_number(double value, int digits);

}  // namespace promenade::motion
