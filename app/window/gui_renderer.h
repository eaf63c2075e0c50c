// Puts what Dear ImGui drew on the screen. Needs a current OpenGL context.
#pragma once

namespace promenade::app {

class GuiRenderer {
 public:
  GuiRenderer();
  ~GuiRenderer();
  GuiRenderer(const GuiRenderer&) = delete;
  GuiRenderer& operator=(const GuiRenderer&) = delete;

  void upload_fonts();  // after the atlas changed
  void draw();          // what ImGui::Render left
};

}  // namespace promenade::app
