#include "app/written_text.h"

#include <algorithm>

#include "app/line_breaks.h"
#include "study/utf8.h"

namespace promenade::app {
namespace {

std::size_t same_beginning(std::string_view a, std::string_view b) {
  const auto end = std::mismatch(a.begin(), a.end(), b.begin(), b.end());
  return static_cast<std::size_t>(end.first - a.begin());
}

std::size_t same_end(std::string_view a, std::string_view b, std::size_t beginning) {
  const std::size_t most = std::min(a.size(), b.size()) - beginning;
  std::size_t count = 0;
  while (count < most && a[a.size() - 1 - count] == b[b.size() - 1 - count]) ++count;
  return count;
}

}  // namespace

void WrittenText::set(std::string words) {
  words_ = std::move(words);
  wrap();
}

void WrittenText::fit(float width, const std::function<float(std::string_view)>& measure) {
  measure_ = measure;
  if (width == width_) return;
  width_ = width;
  wrap();
}

void WrittenText::wrap() {
  ends_.clear();
  shown_ = words_;
  if (width_ <= 0) return;
  for (const std::string_view line : break_lines(words_, width_, measure_)) {
    const auto start = static_cast<std::size_t>(line.data() - words_.data());
    if (start > 0 && words_[start - 1] != '\n') ends_.push_back(start);
  }
  for (std::size_t i = 0; i < ends_.size(); ++i) shown_.insert(ends_[i] + i, 1, '\n');
}

std::size_t WrittenText::in_words(std::size_t shown) const {
  std::size_t before = 0;
  while (before < ends_.size() && ends_[before] + before < shown) ++before;
  return shown - before;
}

std::size_t WrittenText::in_shown(std::size_t words) const {
  const auto before = std::upper_bound(ends_.begin(), ends_.end(), words) - ends_.begin();
  return words + static_cast<std::size_t>(before);
}

std::size_t WrittenText::edited(std::string_view now, std::size_t caret, int most) {
  const std::size_t beginning = same_beginning(shown_, now);
  const std::size_t end = same_end(shown_, now, beginning);
  const std::string_view added = now.substr(beginning, now.size() - end - beginning);
  std::string head = words_.substr(0, in_words(beginning));
  std::string tail = words_.substr(in_words(shown_.size() - end));
  const bool nothing_gone = head.size() + tail.size() == words_.size();
  if (added.empty() && nothing_gone && now.size() < shown_.size()) {
    if (caret < caret_) {
      study::drop_last_character(head);
    } else {
      tail.erase(0, study::first_characters(tail, 1).size());
    }
  }
  const std::size_t behind = beginning + added.size();  // in `now`, of what was added
  const std::size_t at = head.size() + added.size() - (behind - std::min(caret, behind));
  words_ = head.append(added).append(tail);
  words_.resize(study::first_characters(words_, most).size());
  wrap();
  return caret_ = in_shown(std::min(at, words_.size()));
}

}  // namespace promenade::app
