#include "study/person_code.h"

#include "motion/did_you_mean.h"

namespace promenade::study {
namespace {

constexpr int modulus = static_cast<int>(code_characters.size());
static_assert(modulus == 29, "a prime, or typing errors slip through");

// -1: none of them.
int value_of(char character) {
  const auto found = code_characters.find(character);
  return found == std::string_view::npos ? -1 : static_cast<int>(found);
}

}  // namespace

std::string tidy_code(std::string_view typed) {
  std::string code;
  for (const char c : typed) {
    if (c == ' ' || c == '-') continue;
    code += c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
  }
  return code;
}

bool is_person_code(std::string_view code) {
  if (code.size() != code_length) return false;
  int sum = 0;
  for (int i = 0; i < code_length; ++i) {
    const int value = value_of(code[static_cast<std::size_t>(i)]);
    if (value < 0) return false;
    sum += (i + 1) * value;
  }
  return sum % modulus == 0;
}

std::string draw_person_code(Rng& rng) {
  std::string code;
  int sum = 0;
  for (int i = 1; i < code_length; ++i) {
    const auto value = static_cast<int>(rng.below(static_cast<std::uint64_t>(modulus)));
    code += code_characters[static_cast<std::size_t>(value)];
    sum += i * value;
  }
  int check = 0;
  while ((sum + code_length * check) % modulus != 0) ++check;
  return code + code_characters[static_cast<std::size_t>(check)];
}

std::string meant_code(std::string_view typed, const std::vector<std::string>& codes) {
  std::string meant;
  for (const std::string& code : codes) {
    if (edit_distance(tidy_code(typed), code) > 1) continue;
    if (!meant.empty()) return "";
    meant = code;
  }
  return meant;
}

}  // namespace promenade::study
