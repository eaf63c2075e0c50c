#include "app/window/growing_gui.h"

#include "study/utf8.h"

namespace promenade::app {

bool GrowingGui::add(const std::vector<std::string>& words) {
  bool more = false;
  for (const std::string_view word : words) {
    for (std::size_t at = 0; at < word.size();) {
      const study::Character one = study::first_character(word.substr(at));
      if (seen_.insert(one.code).second) {
        characters_ += word.substr(at, one.bytes);
        more = true;
      }
      at += one.bytes;
    }
  }
  return more;
}

Gui& GrowingGui::gui_for(const std::vector<std::string>& words, const Window& window) {
  if (add(words) || !gui_) {
    renderer_.reset();
    gui_.emplace(palette_, std::vector<std::string>{characters_});
    renderer_ = std::make_unique<GuiRenderer>();
  }
  gui_->use();
  if (gui_->fit(window.width(), window.height())) renderer_->upload_fonts();
  return *gui_;
}

}  // namespace promenade::app
