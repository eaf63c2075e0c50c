// Words and numbers out of a text, with their places. Shared by the readers of
// capture formats. Lines may end in LF, CR LF or CR; nothing depends on the locale.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "motion/problem.h"

namespace promenade::motion {

// What a word says as a number.
struct ScannedNumber {
  double value = 0;
  const char* trouble = nullptr;  // why it is none, as a part of a sentence
};
ScannedNumber to_number(std::string_view word);

// "Hips" and "hips" alike.
bool same_word(std::string_view a, std::string_view b);

class Scanner {
 public:
  Scanner(std::string_view text, std::string file);

  bool at_end();                                // nothing but white space is left
  bool at_line_end();                           // nothing but blanks is left in this line
  std::string_view peek();                      // the next word, empty at the end
  std::string_view next();                      // takes it
  bool take(std::string_view word);             // takes the next word if it is this one
  std::string_view rest_of_line();              // or up to a "{", without blanks around it
  std::size_t position() const { return at_; }  // where the next character is
  std::size_t left() const { return text_.size() - at_; }

  // Problems are placed at the word taken last, or at a position.
  void error(std::string message) { error_at(word_at_, std::move(message)); }
  void error_at(std::size_t position, std::string message);
  void warn_at(std::size_t position, std::string message);
  std::size_t word_position() const { return word_at_; }
  bool full() const { return errors_ >= 20; }  // enough has been said
  bool failed() const { return errors_ > 0; }
  [[noreturn]] void give_up();  // throws InputError with all problems
  std::vector<Problem> warnings() const;

 private:
  void skip_white();
  void add(std::size_t position, std::string message, Severity severity);

  std::string_view text_;
  std::string file_;
  std::size_t at_ = 0;
  std::size_t word_at_ = 0;
  int errors_ = 0;
  int warnings_ = 0;
  std::vector<Problem> problems_;
};

}  // namespace promenade::motion
