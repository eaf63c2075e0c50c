#include "app/gui.h"

#include "app/window/input_queue.h"

namespace promenade::app {

Gui::Gui(const Palette& palette, std::vector<std::string> words)
    : context_(ImGui::CreateContext()), words_(std::move(words)) {
  IMGUI_CHECKVERSION();
  use();
  ImGuiIO& io = ImGui::GetIO();
  io.IniFilename = nullptr;  // nothing is remembered between sessions
  io.LogFilename = nullptr;
  io.BackendFlags |= ImGuiBackendFlags_RendererHasVtxOffset;
  // The pointer of a study is the system's; a dead key must not type twice.
  io.ConfigFlags |= ImGuiConfigFlags_NoMouseCursorChange;
  InputQueue::set_up(io);
  look_.palette = palette;
  look_.scale = 0;
}

Gui::~Gui() { ImGui::DestroyContext(context_); }

bool Gui::fit(int width, int height, double share) {
  ImGuiIO& io = ImGui::GetIO();
  io.DisplaySize = {static_cast<float>(width), static_cast<float>(height)};
  layout_ = make_layout(width, height, share);
  if (look_.scale == layout_.scale) return false;
  look_.scale = layout_.scale;
  look_.fonts = load_fonts(*io.Fonts, look_.scale, words_);
  set_style(look_.scale, look_.palette);
  return true;
}

}  // namespace promenade::app
