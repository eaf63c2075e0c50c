// When the display goes away under a running program: its X server has died, or the connection
// to it. Nothing can be shown any more, and Xlib lets nobody go on.
#pragma once

#include <functional>
#include <string>

namespace promenade::app {

// For as long as it lives, `last_words` is called once when that happens, and gives the sentence
// with which the program then ends (exit code 1). It must not draw. One at a time.
class DisplayLossGuard {
 public:
  explicit DisplayLossGuard(std::function<std::string()> last_words);
  ~DisplayLossGuard();
  DisplayLossGuard(const DisplayLossGuard&) = delete;
  DisplayLossGuard& operator=(const DisplayLossGuard&) = delete;
};

}  // namespace promenade::app
