#include "motion/scanner.h"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>

namespace promenade::motion {
namespace {

bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\v' || c == '\f'; }
bool is_line_end(char c) { return c == '\n' || c == '\r'; }
bool is_white(char c) { return is_blank(c) || is_line_end(c); }

char lower(char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; }

}  // namespace

ScannedNumber to_number(std::string_view word) {
  if (word.size() > 1 && word[0] == '+' && word[1] != '-') word.remove_prefix(1);
  ScannedNumber number;
  const char* end = word.data() + word.size();
  const auto [stop, error] = std::from_chars(word.data(), end, number.value);
  if (stop != end || error == std::errc::invalid_argument) {
    number.trouble = "is not a number";
  } else if (error == std::errc::result_out_of_range) {
    // Too small is 0; too large is nothing that a capture holds.
    const bool small = word.find("e-") != word.npos || word.find("E-") != word.npos;
    number.value = 0;
    if (!small) number.trouble = "is too large";
  } else if (!std::isfinite(number.value)) {
    number.trouble = "is not finite";
  }
  return number;
}

bool same_word(std::string_view a, std::string_view b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](char x, char y) { return lower(x) == lower(y); });
}

Scanner::Scanner(std::string_view text, std::string file) : text_(text), file_(std::move(file)) {
  if (text_.substr(0, 3) == "\xef\xbb\xbf") at_ = 3;
  word_at_ = at_;
}

void Scanner::skip_white() {
  while (at_ < text_.size() && is_white(text_[at_])) ++at_;
}

bool Scanner::at_end() {
  skip_white();
  return at_ == text_.size();
}

bool Scanner::at_line_end() {
  while (at_ < text_.size() && is_blank(text_[at_])) ++at_;
  return at_ == text_.size() || is_line_end(text_[at_]);
}

std::string_view Scanner::peek() {
  skip_white();
  std::size_t end = at_;
  while (end < text_.size() && !is_white(text_[end])) ++end;
  return text_.substr(at_, end - at_);
}

std::string_view Scanner::next() {
  const std::string_view word = peek();
  word_at_ = at_;
  at_ += word.size();
  return word;
}

bool Scanner::take(std::string_view word) {
  if (!same_word(peek(), word)) return false;
  next();
  return true;
}

std::string_view Scanner::rest_of_line() {
  if (at_line_end()) return {};
  word_at_ = at_;
  std::size_t end = at_;
  while (end < text_.size() && !is_line_end(text_[end])) ++end;
  end = std::min(end, text_.find('{', at_));
  const std::size_t from = at_;
  at_ = end;
  while (end > from && is_blank(text_[end - 1])) --end;
  return text_.substr(from, end - from);
}

void Scanner::add(std::size_t position, std::string message, Severity severity) {
  int line = 1;
  std::size_t start = text_.substr(0, 3) == "\xef\xbb\xbf" ? 3 : 0;
  position = std::max(position, start);
  for (std::size_t i = start; i < position; ++i) {
    if (text_[i] == '\n' || (text_[i] == '\r' && (i + 1 == text_.size() || text_[i + 1] != '\n'))) {
      ++line;
      start = i + 1;
    }
  }
  const int column = static_cast<int>(position - start) + 1;
  problems_.push_back({file_, line, column, std::move(message), severity});
}

void Scanner::error_at(std::size_t position, std::string message) {
  ++errors_;
  add(position, std::move(message), Severity::error);
}

void Scanner::warn_at(std::size_t position, std::string message) {
  if (++warnings_ > 20) return;
  add(position, std::move(message), Severity::warning);
}

void Scanner::give_up() { throw InputError(problems_); }

std::vector<Problem> Scanner::warnings() const {
  std::vector<Problem> found;
  for (const Problem& problem : problems_) {
    if (problem.severity == Severity::warning) found.push_back(problem);
  }
  return found;
}

}  // namespace promenade::motion
