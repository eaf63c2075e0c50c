#include "app/window/gui_renderer.h"

#include <backends/imgui_impl_opengl3.h>
#include <epoxy/gl.h>
#include <imgui.h>

#include <cstdint>

namespace promenade::app {

GuiRenderer::GuiRenderer() { ImGui_ImplOpenGL3_Init("#version 330 core"); }

GuiRenderer::~GuiRenderer() { ImGui_ImplOpenGL3_Shutdown(); }

void GuiRenderer::upload_fonts() {
  ImGui_ImplOpenGL3_DestroyFontsTexture();
  ImGui_ImplOpenGL3_NewFrame();  // makes the programs the first time
  ImGui_ImplOpenGL3_DestroyFontsTexture();
  ImGui_ImplOpenGL3_CreateFontsTexture();
  // Text lies on whole pixels: nearest is as sharp and much cheaper in software.
  const auto texture = static_cast<GLuint>(
      reinterpret_cast<std::uintptr_t>(static_cast<void*>(ImGui::GetIO().Fonts->TexID)));
  glBindTexture(GL_TEXTURE_2D, texture);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
}

void GuiRenderer::draw() { ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData()); }

}  // namespace promenade::app
