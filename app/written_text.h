// Words that are written in a box of several lines. Dear ImGui breaks no lines in a field:
// it is shown the words with further line ends, which are taken out of what it gives back.
#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace promenade::app {

class WrittenText {
 public:
  const std::string& words() const { return words_; }
  const std::string& shown() const { return shown_; }
  void set(std::string words);

  // How wide a line may be, in the unit of measure(text). 0: as wide as it is.
  void fit(float width, const std::function<float(std::string_view)>& measure);
  // Dear ImGui's caret in `shown`, bytes.
  void stand_at(std::size_t caret) { caret_ = caret; }
  // By hand `shown` has become this, of which `most` characters can be kept. Returns where
  // the caret is now. Whoever deletes a line end that is none of the words' means the
  // character beyond it.
  std::size_t edited(std::string_view now, std::size_t caret, int most);

 private:
  std::size_t in_words(std::size_t shown) const;
  std::size_t in_shown(std::size_t words) const;
  void wrap();

  std::string words_, shown_;
  std::vector<std::size_t> ends_;  // where a line end was put in, places in `words_`
  std::function<float(std::string_view)> measure_;
  float width_ = 0;
  std::size_t caret_ = 0;
};

}  // namespace promenade::app
