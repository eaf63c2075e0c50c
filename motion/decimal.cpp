#include "motion/decimal.h"

#include <algorithm>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstring>

namespace promenade::motion {
namespace {

bool is_digit(char c) { return c >= '0' && c <= '9'; }
bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\v' || c == '\f'; }
bool ends_number(char c) { return is_blank(c) || c == '\n' || c == '\r'; }

// All of these are exact as doubles and the whole ones as integers.
constexpr double powers_of_10[] = {1e0,  1e1,  1e2,  1e3,  1e4,  1e5,  1e6,  1e7,
                                   1e8,  1e9,  1e10, 1e11, 1e12, 1e13, 1e14, 1e15,
                                   1e16, 1e17, 1e18, 1e19, 1e20, 1e21, 1e22};
constexpr std::uint64_t whole_powers_of_10[] = {1,       10,        100,        1'000,      10'000,
                                                100'000, 1'000'000, 10'000'000, 100'000'000};

// Digits read so far: their number without the point, and how it is to be scaled.
struct Digits {
  std::uint64_t number = 0;
  int count = 0;
  int exponent = 0;
};

// Up to eight digits at once, without a branch for each: eight bytes as one integer, the
// first digit in the lowest byte. Bytes that are no digits get their highest bit set; the
// digits before the first such byte are moved to the top and joined in pairs, fours, eight.
int add_eight(const char* at, Digits& digits) {
  std::uint64_t bytes = 0;
  std::memcpy(&bytes, at, 8);
  bytes ^= 0x3030303030303030;
  const std::uint64_t others = ((bytes + 0x7676767676767676) | bytes) & 0x8080808080808080;
  const int count = std::countr_zero(others) / 8;  // 8 if there is none
  const int empty = 4 * (8 - count);
  bytes = bytes << empty << empty;
  bytes = (10 * bytes + (bytes >> 8)) & 0x00ff00ff00ff00ff;
  bytes = (100 * bytes + (bytes >> 16)) & 0x0000ffff0000ffff;
  bytes = (10000 * bytes + (bytes >> 32)) & 0xffffffff;
  digits.number = digits.number * whole_powers_of_10[count] + bytes;
  digits.count += count;
  return count;
}

// The same one by one, where less than eight bytes are left.
int add_each(const char* at, const char* last, Digits& digits) {
  int count = 0;
  for (; count < 8 && at + count != last && is_digit(at[count]); ++count) {
    digits.number = 10 * digits.number + static_cast<std::uint64_t>(at[count] - '0');
  }
  digits.count += count;
  return count;
}

// At most 19 digits fit into 64 bits, so that 24 are read at most.
const char* add_digits(const char* at, const char* last, Digits& digits) {
  for (int group = 0; group < 3; ++group) {
    const bool wide = std::endian::native == std::endian::little && last - at >= 8;
    const int count = wide ? add_eight(at, digits) : add_each(at, last, digits);
    at += count;
    if (count < 8) break;
  }
  return at;
}

// "e-05" and its like; leaves `at` when no digit follows. Stops counting where no
// exponent matters any more.
const char* add_exponent(const char* at, const char* last, int& exponent) {
  const char* next = at + 1;
  const bool negative = next != last && *next == '-';
  if (next != last && (*next == '-' || *next == '+')) ++next;
  if (next == last || !is_digit(*next)) return at;
  int number = 0;
  for (; next != last && is_digit(*next); ++next) {
    if (number < 10000) number = 10 * number + (*next - '0');
  }
  exponent += negative ? -number : number;
  return next;
}

// A number of few digits and small exponent, and the place behind it; `first` when it is
// none or needs a closer look.
inline const char* short_number(const char* first, const char* last, double& value) {
  const bool negative = first != last && *first == '-';
  const char* at = first + (negative ? 1 : 0);
  Digits digits;
  at = add_digits(at, last, digits);
  if (at != last && *at == '.') {
    const int whole = digits.count;
    at = add_digits(at + 1, last, digits);
    digits.exponent = whole - digits.count;
  }
  if (digits.count == 0 || digits.count > 19) return first;
  if (at != last && (*at | 0x20) == 'e') at = add_exponent(at, last, digits.exponent);
  // Number and power are exact doubles, so that one division or product rounds once
  // (Clinger 1990).
  constexpr std::uint64_t most = std::uint64_t{1} << 53;
  if (digits.number > most || digits.exponent < -22 || digits.exponent > 22) return first;
  const auto exact = static_cast<double>(digits.number);
  value = digits.exponent <= 0 ? exact / powers_of_10[-digits.exponent]
                               : exact * powers_of_10[digits.exponent];
  if (negative) value = -value;
  return at;
}

// The same for every finite number.
const char* any_number(const char* first, const char* last, double& value) {
  const auto [stop, error] = std::from_chars(first, last, value);
  return error == std::errc() && std::isfinite(value) ? stop : first;
}

// The number was out of range: is its magnitude too small (rather than too large)?
// Only its first digit that is not 0 and its exponent decide.
bool is_tiny(std::string_view word) {
  const std::size_t e = word.find_first_of("eE");
  int exponent = 0;
  if (e != word.npos) add_exponent(word.data() + e, word.data() + word.size(), exponent);
  const std::string_view digits = word.substr(0, e);
  const std::size_t point = std::min(digits.find('.'), digits.size());
  const std::size_t first = digits.find_first_of("123456789");
  return static_cast<std::int64_t>(point) - static_cast<std::int64_t>(first) + exponent < 0;
}

}  // namespace

DecimalRun read_decimals(const char* first, const char* last, double* out, std::size_t most) {
  DecimalRun run{0, nullptr, first};
  for (; run.count < most; ++run.count) {
    const char* at = run.end;
    while (at != last && is_blank(*at)) ++at;
    double value = 0;
    const char* end = short_number(at, last, value);
    if (end == at) end = any_number(at, last, value);
    if (end == at || (end != last && !ends_number(*end))) break;
    if (out) out[run.count] = value;
    run.last_number = at;
    run.end = end;
  }
  return run;
}

ScannedNumber to_number(std::string_view word) {
  const char* const end = word.data() + word.size();
  if (word.size() > 1 && word[0] == '+' && word[1] != '-') word.remove_prefix(1);
  ScannedNumber number;
  const auto [stop, error] = std::from_chars(word.data(), end, number.value);
  if (stop != end || error == std::errc::invalid_argument) {
    const bool comma = word.find(',') != word.npos;
    number.trouble = comma ? "is not a number; decimals want a point" : "is not a number";
  } else if (error == std::errc::result_out_of_range) {
    // Too small is 0; too large is nothing that a capture holds.
    number.value = word.front() == '-' ? -0.0 : 0.0;
    if (!is_tiny(word)) number.trouble = "is too large";
  } else if (!std::isfinite(number.value)) {
    number.trouble = "is not finite";
  }
  return number;
}

std::string short_number(double value, int digits) {
  char text[64];
  const auto end =
      std::to_chars(text, text + sizeof text, value, std::chars_format::general, digits).ptr;
  return {text, end};
}

}  // namespace promenade::motion
