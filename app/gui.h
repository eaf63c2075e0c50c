// Dear ImGui with our fonts and style, at the size of the window. Needs no window
// and no graphics card, so that tests drive the same screens.
#pragma once

#include <string>
#include <vector>

#include "app/layout.h"
#include "app/look.h"

namespace promenade::app {

class Gui {
 public:
  // `words`: every text that may be shown, for the characters of the fonts.
  Gui(const Palette& palette, std::vector<std::string> words);
  ~Gui();
  Gui(const Gui&) = delete;
  Gui& operator=(const Gui&) = delete;

  // What is drawn from now on is drawn with this one.
  void use() { ImGui::SetCurrentContext(context_); }
  // Follows the size of the window, `share` of which the picture takes. True: the fonts are new,
  // and so must be their texture.
  bool fit(int width, int height, double share = 1);
  const Look& look() const { return look_; }
  const Layout& layout() const { return layout_; }

 private:
  ImGuiContext* context_;
  std::vector<std::string> words_;
  Look look_;
  Layout layout_;
};

}  // namespace promenade::app
