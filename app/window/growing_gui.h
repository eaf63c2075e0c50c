// A Gui in a window whose words are not known beforehand: names and notes bring characters that no
// font was made with, and then the fonts are made anew.
#pragma once

#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "app/gui.h"
#include "app/window/gui_renderer.h"
#include "app/window/window.h"

namespace promenade::app {

class GrowingGui {
 public:
  // Needs a current OpenGL context from the first gui_for() on. `words`: what is known beforehand.
  explicit GrowingGui(const Palette& palette, const std::vector<std::string>& words = {})
      : palette_(palette) {
    add(words);
  }

  // Ready to draw at the size of the window, with the characters of these words too. What was being
  // written in a field is let go when the fonts are made anew.
  Gui& gui_for(const std::vector<std::string>& words, const Window& window);
  GuiRenderer& renderer() { return *renderer_; }

 private:
  bool add(const std::vector<std::string>& words);

  Palette palette_;
  std::set<unsigned int> seen_;
  std::string characters_;  // each once
  std::optional<Gui> gui_;
  std::unique_ptr<GuiRenderer> renderer_;
};

}  // namespace promenade::app
