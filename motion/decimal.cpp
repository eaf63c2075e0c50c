#include "motion/decimal.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdint>

namespace promenade::motion {
namespace {

bool is_digit(char c) { return c >= '0' && c <= '9'; }

// All of these are exact as doubles.
constexpr double powers_of_10[] = {1e0,  1e1,  1e2,  1e3,  1e4,  1e5,  1e6,  1e7,
                                   1e8,  1e9,  1e10, 1e11, 1e12, 1e13, 1e14, 1e15,
                                   1e16, 1e17, 1e18, 1e19, 1e20, 1e21, 1e22};

const char* add_digits(const char* at, const char* last, std::uint64_t& number) {
  while (at != last && is_digit(*at)) {
    number = 10 * number + static_cast<std::uint64_t>(*at++ - '0');
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

// The number was out of range: is its magnitude too small (rather than too large)?
// Only its first digit that is not 0 and its exponent decide.
bool is_tiny(std::string_view word) {
  const std::size_t e = word.find_first_of("eE");
  std::int64_t exponent = 0;
  if (e != word.npos) {
    int stated = 0;
    add_exponent(word.data() + e, word.data() + word.size(), stated);
    exponent = stated;
  }
  const std::string_view digits = word.substr(0, e);
  const std::size_t point = std::min(digits.find('.'), digits.size());
  const std::size_t first = digits.find_first_of("123456789");
  return static_cast<std::int64_t>(point) - static_cast<std::int64_t>(first) + exponent < 0;
}

}  // namespace

Decimal read_decimal(const char* first, const char* last) {
  const char* at = first;
  const bool negative = at != last && *at == '-';
  if (at != last && (*at == '-' || *at == '+')) ++at;
  std::uint64_t number = 0;
  const char* const whole = at;
  at = add_digits(at, last, number);
  auto digits = at - whole;
  int exponent = 0;
  if (at != last && *at == '.') {
    const char* const fraction = ++at;
    at = add_digits(at, last, number);
    exponent = -static_cast<int>(std::min<std::ptrdiff_t>(at - fraction, 100));
    digits += at - fraction;
  }
  // 20 digits overflow 64 bits.
  if (digits == 0 || digits > 19) return {0, first};
  if (at != last && (*at == 'e' || *at == 'E')) at = add_exponent(at, last, exponent);
  // Number and power are exact doubles, so that one division or product rounds once
  // (Clinger 1990).
  constexpr std::uint64_t most = std::uint64_t{1} << 53;
  if (number > most || exponent < -22 || exponent > 22) return {0, first};
  const auto exact = static_cast<double>(number);
  const double value =
      exponent < 0 ? exact / powers_of_10[-exponent] : exact * powers_of_10[exponent];
  return {negative ? -value : value, at};
}

ScannedNumber to_number(std::string_view word) {
  const char* const end = word.data() + word.size();
  if (const Decimal decimal = read_decimal(word.data(), end); decimal.end == end && !word.empty()) {
    return {decimal.value, nullptr};
  }
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

}  // namespace promenade::motion
