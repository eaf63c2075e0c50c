// Words and numbers out of a text, with their places. Shared by the readers of
// capture formats. Lines may end in LF, CR LF or CR; nothing depends on the locale.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "motion/decimal.h"
#include "motion/problem.h"

namespace promenade::motion {

// "Hips" and "hips" alike.
bool same_word(std::string_view a, std::string_view b);

// A word of the text as a message shows it: in quotes, not too long.
std::string quoted(std::string_view word);

// "; did you mean 'OFFSET'?" for a word, whatever its case; nothing if none is near.
std::string meant(std::string_view word, const std::vector<std::string>& names);

// How a format parts its words. Biovision: a brace is a word of its own. Acclaim:
// "#" starts a comment, and commas and parentheses are blanks.
enum class Punctuation { biovision, acclaim };

class Scanner {
 public:
  Scanner(std::string_view text, std::string file,
          Punctuation punctuation = Punctuation::biovision);

  bool at_end();                                // nothing but white space is left
  bool at_line_end();                           // nothing but blanks is left in this line
  std::string_view peek();                      // the next word, empty at the end
  std::string_view next();                      // takes it
  bool take(std::string_view word);             // takes the next word if it is this one
  bool take_start(std::string_view start);      // the same for the start of a word
  std::string_view rest_of_line();              // or up to a "{", without blanks around it
  void skip_line();                             // what is left of it, whatever it is
  std::size_t position() const { return at_; }  // where the next character is
  std::size_t left() const { return text_.size() - at_; }
  std::size_t lines() const;  // at most so many lines are left

  // Takes numbers from this line, at most so many, into `out` (nowhere if null). Stops
  // early at the end of the line and before a word that is no plain number.
  std::size_t take_numbers(double* out, std::size_t most);

  // Problems are placed at the word taken last, or at a position.
  void error(std::string message) { error_at(word_at_, std::move(message)); }
  void error_at(std::size_t position, std::string message);
  void warn_at(std::size_t position, std::string message);
  std::size_t word_position() const { return word_at_; }
  bool full() const { return errors_ >= 20; }  // enough has been said
  bool failed() const { return errors_ > 0; }
  [[noreturn]] void give_up();  // throws InputError with all problems, by their places
  [[noreturn]] void refuse(std::string message) {  // the same, with this one, too
    error(std::move(message));
    give_up();
  }
  // "expected ..., found 'word'", and which of the names it was probably meant to be.
  [[noreturn]] void refuse_next(const std::string& expected,
                                const std::vector<std::string>& names = {});
  std::vector<Problem> warnings() const;

 private:
  bool is_blank(char c) const;
  void skip_comment();
  void skip_white();
  void add(std::size_t position, std::string message, Severity severity);

  std::string_view text_;
  std::string file_;
  bool acclaim_ = false;
  std::size_t at_ = 0;
  std::size_t word_at_ = 0;
  int errors_ = 0;
  int warnings_ = 0;
  std::vector<Problem> problems_;
};

}  // namespace promenade::motion
