#include "study/toml_limits.h"

#include "motion/problem.h"
#include "study/utf8.h"

namespace promenade::study {
namespace {

constexpr int most_parts = 32;
constexpr int deepest = 64;

class Scan {
 public:
  Scan(const std::string& file, std::string_view text) : file_(file), text_(text) {}

  void run() {
    while (at_ < text_.size()) {
      const char letter = text_[at_];
      if (letter == '#') {
        skip_comment();
      } else if (letter == '"' || letter == '\'') {
        skip_string(letter);
      } else {
        count(letter);
        step();
      }
    }
  }

 private:
  // Dots with nothing but words, quoted words and blanks between them are one key; a
  // number has no more than one.
  void count(char letter) {
    if (letter == '.' && ++dots_ >= most_parts) {
      refuse("a key must not have more than " + std::to_string(most_parts) + " parts");
    }
    if (std::string_view("=,[]{}\n").find(letter) != std::string_view::npos) dots_ = 0;
    if ((letter == '[' || letter == '{') && ++depth_ > deepest) {
      refuse("lists and tables must not be nested more than " + std::to_string(deepest) + " deep");
    }
    if ((letter == ']' || letter == '}') && depth_ > 0) --depth_;
  }

  void skip_comment() {
    while (at_ < text_.size() && text_[at_] != '\n') step();
  }

  // One that is not closed ends with its line, or with the text.
  void skip_string(char quote) {
    const std::string three(3, quote);
    const bool long_one = text_.substr(at_, 3) == three;
    const std::string_view end = long_one ? std::string_view(three) : text_.substr(at_, 1);
    skip(end.size());
    while (at_ < text_.size() && text_.substr(at_, end.size()) != end) {
      if (text_[at_] == '\n' && !long_one) return;
      skip(text_[at_] == '\\' && quote == '"' ? 2 : 1);
    }
    skip(end.size());
    // Before the three quotes of the end, up to two more belong to the text.
    for (int i = 0; long_one && i < 2 && text_.substr(at_, 1) == end.substr(0, 1); ++i) step();
  }

  void skip(std::size_t letters) {
    for (std::size_t i = 0; i < letters && at_ < text_.size(); ++i) step();
  }

  // Columns count characters, of which a byte 10xxxxxx is no beginning.
  void step() {
    const char letter = text_[at_++];
    if (letter == '\n') {
      ++line_;
      column_ = 1;
    } else if (at_ == text_.size() || begins_character(text_[at_])) {
      ++column_;
    }
  }

  [[noreturn]] void refuse(const std::string& message) const {
    throw InputError({{file_, line_, column_, message, {}}});
  }

  const std::string& file_;
  std::string_view text_;
  std::size_t at_ = 0;
  int line_ = 1, column_ = 1;
  int dots_ = 0, depth_ = 0;
};

}  // namespace

void refuse_deep_toml(const std::string& file, std::string_view text) { Scan(file, text).run(); }

}  // namespace promenade::study
