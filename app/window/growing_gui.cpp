#include "app/window/growing_gui.h"

#include "study/utf8.h"

namespace promenade::app {

bool GrowingGui::add(const std::vector<std::string>& words) {
  bool more = false;
  for (const std::string& word : words) {
    if (!seen_.insert(word).second) continue;
    for (std::size_t at = 0; at < word.size();) {
      const study::Character one = study::first_character(std::string_view(word).substr(at));
      more |= characters_.insert(one.code).second;
      at += one.bytes;
    }
  }
  return more;
}

Gui& GrowingGui::gui_for(const std::vector<std::string>& words, const Window& window) {
  if (add(words) || !gui_) {
    renderer_.reset();
    gui_.emplace(palette_, std::vector<std::string>(seen_.begin(), seen_.end()));
    renderer_ = std::make_unique<GuiRenderer>();
  }
  gui_->use();
  if (gui_->fit(window.width(), window.height())) renderer_->upload_fonts();
  return *gui_;
}

}  // namespace promenade::app
