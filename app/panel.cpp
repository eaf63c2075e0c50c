#include "app/panel.h"

#include <cmath>

namespace promenade::study {

void InterfacePanel::row(std::string_view kind, std::string_view target, const app::Box& box,
                         std::string_view label, bool marked) {
  if (app::list_row(ui_, kind, target, box, label, marked)) {
    report({.kind = std::string(kind), .target = std::string(target)});
  }
}

void InterfacePanel::slide(std::string_view target, const app::Box& box, double value, double start,
                           std::string_view kind) {
  if (const std::optional<double> moved = app::slider(ui_, kind, target, box, value, start)) {
    report({.kind = std::string(kind), .target = std::string(target), .value = *moved});
  }
}

void InterfacePanel::press(std::string_view kind, std::string_view target, const app::Box& box,
                           std::string_view label) {
  if (app::small_button(ui_, kind, target, box, label)) {
    report({.kind = std::string(kind), .target = std::string(target)});
  }
}

void InterfacePanel::press(std::string_view kind, std::string_view target, const app::Box& box,
                           app::Icon icon, bool enabled) {
  if (app::icon_button(ui_, kind, target, box, icon, enabled)) {
    report({.kind = std::string(kind), .target = std::string(target)});
  }
}

void InterfacePanel::write(std::string_view kind, std::string_view target, const app::Box& box,
                           const std::string& text, const std::string& hint, int most) {
  std::string written = text;
  if (app::text_field(ui_, kind, target, box, written, {.hint = hint.c_str(), .most = most})) {
    report({.kind = std::string(kind), .target = std::string(target), .text = written});
  }
}

void InterfacePanel::tile(std::string_view kind, std::string_view target, const app::Box& box) {
  if (app::tile(ui_, kind, target, box)) {
    report({.kind = std::string(kind), .target = std::string(target)});
  }
}

void InterfacePanel::figure(const app::Box& box, const Eigen::VectorXd& weights,
                            const app::Rgb& colour) {
  if (content_.figures != nullptr) {
    content_.figures->ask(box, app::visible_box(), weights, colour);
  }
}

void InterfacePanel::line(ImFont* font, const app::Box& box, const app::Rgb& colour,
                          std::string_view text, app::Align align) {
  app::draw_line(font, box, colour, text, align);
}

float InterfacePanel::begin_scroll(const app::Box& box, float rows_height) {
  ImGui::SetCursorScreenPos({box.x, box.y});
  ImGui::BeginChild("scroll", {box.width, box.height});
  const bool scrolls = rows_height > box.height;
  return box.width - (scrolls ? ImGui::GetStyle().ScrollbarSize : 0);
}

void InterfacePanel::end_scroll() { ImGui::EndChild(); }

}  // namespace promenade::study
