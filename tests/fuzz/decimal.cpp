// Any word as a number: the same double as the C library reads, or refused by both.
#include "motion/decimal.h"

#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <string>

namespace {

bool is_plain(const std::string& word) {
  return !word.empty() && word.find_first_not_of("+-.0123456789eE") == word.npos;
}

bool same_bits(double a, double b) { return std::memcmp(&a, &b, sizeof a) == 0; }

// What the fast way takes, it takes to its end and to the same double.
void check_run(const std::string& word, double expected) {
  double value = 0;
  const auto run =
      promenade::motion::read_decimals(word.data(), word.data() + word.size(), &value, 1);
  const bool good = run.end == word.data() + word.size() && same_bits(value, expected);
  if (run.count == 1 && !good) std::abort();
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string word(reinterpret_cast<const char*>(data), size);
  const promenade::motion::ScannedNumber number = promenade::motion::to_number(word);
  if (!is_plain(word)) {
    if (!number.trouble) std::abort();
    return 0;
  }
  char* end = nullptr;
  const double expected = std::strtod(word.c_str(), &end);  // the C locale: a point
  const bool whole = end == word.c_str() + word.size();
  check_run(word, expected);
  if (!whole || std::isinf(expected)) {
    if (!number.trouble) std::abort();
  } else if (number.trouble ||
             !(same_bits(number.value, expected) || std::fpclassify(expected) != FP_NORMAL)) {
    std::abort();
  }
  return 0;
}
