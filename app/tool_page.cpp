#include "app/tool_page.h"

namespace promenade::app {

void ToolPage::frame(const std::function<void(const Ui&)>& draw) {
  constexpr int most = 64;  // whoever types faster waits for the next frame
  pass(draw);
  for (int k = 1; k < most && !queue_.empty(); ++k) pass(draw);
}

void ToolPage::pass(const std::function<void(const Ui&)>& draw) {
  ImGuiIO& io = ImGui::GetIO();
  io.DeltaTime = 1.0f / 60;
  queue_.feed(io);
  ImGui::NewFrame();
  focus_.begin(widgets_);
  widgets_.clear();
  ImGui::SetNextWindowPos({0, 0});
  ImGui::SetNextWindowSize(io.DisplaySize);
  ImGui::Begin("page", nullptr,
               ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoSavedSettings |
                   ImGuiWindowFlags_NoBackground);
  draw({gui_.look(), gui_.layout(), widgets_, focus_});
  ImGui::End();
  ImGui::Render();
}

}  // namespace promenade::app
