#include "app/window/display_loss.h"

#include <X11/Xlib.h>
#include <fmt/format.h>
#include <unistd.h>

#include <utility>

namespace promenade::app {
namespace {

std::function<std::string()>& words() {
  static std::function<std::string()> words;
  return words;
}

// Xlib ends the program when this returns; destructors would ask the display once more.
int on_loss(Display*) {
  std::string sentence = "the display went away";
  if (const auto last_words = std::exchange(words(), nullptr)) sentence = last_words();
  fmt::print(stderr, "promenade: {}\n", sentence);
  ::_exit(1);
}

}  // namespace

DisplayLossGuard::DisplayLossGuard(std::function<std::string()> last_words) {
  words() = std::move(last_words);
  XSetIOErrorHandler(on_loss);
}

DisplayLossGuard::~DisplayLossGuard() { words() = nullptr; }

}  // namespace promenade::app
