#include "app/tool_page.h"

#include "motion/problem.h"

namespace promenade::app {

void ToolPage::frame(Gui& gui, const std::function<void(const Ui&)>& draw) {
  gui.use();
  constexpr int most = 64;  // whoever types faster waits for the next frame
  pass(gui, draw);
  for (int k = 1; k < most && (focus_.settling() || !queue_.empty()); ++k) pass(gui, draw);
}

void ToolPage::pass(const Gui& gui, const std::function<void(const Ui&)>& draw) {
  ImGuiIO& io = ImGui::GetIO();
  io.DeltaTime = 1.0f / 60;
  if (!focus_.settling()) queue_.feed(io);
  ImGui::NewFrame();
  focus_.begin(widgets_);
  widgets_.clear();
  ImGui::SetNextWindowPos({0, 0});
  ImGui::SetNextWindowSize(io.DisplaySize);
  ImGui::Begin("page", nullptr,
               ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoSavedSettings |
                   ImGuiWindowFlags_NoBackground);
  draw({gui.look(), gui.layout(), widgets_, focus_});
  ImGui::End();
  ImGui::Render();
}

SaveReport report_of_saving(const std::function<void()>& save) {
  try {
    save();
    return {"Saved"};
  } catch (const InputError& error) {
    return {error.problems().front().message, true};
  } catch (const OutsideError& error) {
    return {error.what(), true};
  }
}

}  // namespace promenade::app
