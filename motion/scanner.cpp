#include "motion/scanner.h"

#include <algorithm>

#include "motion/did_you_mean.h"

namespace promenade::motion {
namespace {

constexpr std::string_view byte_order_mark = "\xef\xbb\xbf";

bool is_line_end(char c) { return c == '\n' || c == '\r'; }
bool is_space(char c) { return c == ' ' || c == '\t' || c == '\v' || c == '\f'; }
bool is_brace(char c) { return c == '{' || c == '}'; }
bool is_control(char c) { return (c >= 0 && c < ' ') || c == 0x7f; }

char lower(char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; }

}  // namespace

bool same_word(std::string_view a, std::string_view b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](char x, char y) { return lower(x) == lower(y); });
}

std::string quoted(std::string_view word) {
  constexpr std::size_t most = 40;
  if (word.empty()) return "the end of the file";
  std::string text = "'" + std::string(word.substr(0, most));
  return text + (word.size() > most ? "...'" : "'");
}

std::string meant(std::string_view word, const std::vector<std::string>& names) {
  const std::string name = closest_name_of_any_case(word, names);
  return name.empty() ? "" : "; did you mean " + quoted(name) + "?";
}

Scanner::Scanner(std::string_view text, std::string file, Punctuation punctuation)
    : text_(text), file_(std::move(file)), acclaim_(punctuation == Punctuation::acclaim) {
  // A DOS end of file, or what a disk fills a block with.
  while (!text_.empty() && (text_.back() == '\x1a' || text_.back() == '\0')) {
    text_.remove_suffix(1);
  }
  if (text_.substr(0, 3) == byte_order_mark) at_ = 3;
  word_at_ = at_;
}

bool Scanner::is_blank(char c) const {
  return is_space(c) || (acclaim_ && (c == ',' || c == '(' || c == ')'));
}

void Scanner::skip_comment() {
  if (acclaim_ && at_ < text_.size() && text_[at_] == '#') skip_line();
}

void Scanner::skip_line() {
  while (at_ < text_.size() && !is_line_end(text_[at_])) ++at_;
}

void Scanner::skip_white() {
  do {
    while (at_ < text_.size() && (is_blank(text_[at_]) || is_line_end(text_[at_]))) ++at_;
    skip_comment();
  } while (at_ < text_.size() && is_line_end(text_[at_]));
}

bool Scanner::at_end() {
  skip_white();
  return at_ == text_.size();
}

bool Scanner::at_line_end() {
  while (at_ < text_.size() && is_blank(text_[at_])) ++at_;
  skip_comment();
  return at_ == text_.size() || is_line_end(text_[at_]);
}

std::string_view Scanner::peek() {
  skip_white();
  std::size_t end = at_;
  const auto ends_word = [this](char c) {
    return is_blank(c) || is_line_end(c) || (acclaim_ ? c == '#' : is_brace(c));
  };
  while (end < text_.size() && !ends_word(text_[end])) ++end;
  if (end == at_ && end < text_.size()) ++end;  // a brace
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

bool Scanner::take_start(std::string_view start) {
  if (!same_word(peek().substr(0, start.size()), start)) return false;
  word_at_ = at_;
  at_ += start.size();
  return true;
}

std::string_view Scanner::rest_of_line() {
  if (at_line_end()) return {};
  word_at_ = at_;
  std::size_t end = at_;
  while (end < text_.size() && !is_line_end(text_[end]) && text_[end] != '{') ++end;
  const std::size_t from = at_;
  at_ = end;
  while (end > from && is_blank(text_[end - 1])) --end;
  return text_.substr(from, end - from);
}

std::size_t Scanner::lines() const {
  const std::string_view rest = text_.substr(at_);
  const auto feeds = std::count(rest.begin(), rest.end(), '\n');
  const auto returns = std::count(rest.begin(), rest.end(), '\r');
  return static_cast<std::size_t>(feeds + returns) + 1;
}

std::size_t Scanner::take_numbers(double* out, std::size_t most) {
  const char* const begin = text_.data();
  const DecimalRun run = read_decimals(begin + at_, begin + text_.size(), out, most);
  if (run.last_number) word_at_ = static_cast<std::size_t>(run.last_number - begin);
  at_ = static_cast<std::size_t>(run.end - begin);
  return run.count;
}

void Scanner::add(std::size_t position, std::string message, Severity severity) {
  int line = 1;
  std::size_t start = text_.substr(0, 3) == byte_order_mark ? 3 : 0;
  position = std::max(position, start);
  for (std::size_t i = start; i < position; ++i) {
    if (text_[i] == '\n' || (text_[i] == '\r' && (i + 1 == text_.size() || text_[i + 1] != '\n'))) {
      ++line;
      start = i + 1;
    }
  }
  const int column = static_cast<int>(position - start) + 1;
  // What a broken file holds must not steer the terminal.
  std::replace_if(message.begin(), message.end(), is_control, '?');
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

void Scanner::give_up() {
  std::stable_sort(problems_.begin(), problems_.end(), [](const Problem& a, const Problem& b) {
    return a.line != b.line ? a.line < b.line : a.column < b.column;
  });
  throw InputError(problems_);
}

void Scanner::refuse_next(const std::string& expected, const std::vector<std::string>& names) {
  const std::string_view word = next();
  refuse(expected + ", found " + quoted(word) + meant(word, names));
}

std::vector<Problem> Scanner::warnings() const {
  std::vector<Problem> found;
  for (const Problem& problem : problems_) {
    if (problem.severity == Severity::warning) found.push_back(problem);
  }
  return found;
}

}  // namespace promenade::motion
