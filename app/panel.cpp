#include "app/panel.h"

#include <cmath>

namespace promenade::study {

void InterfacePanel::row(std::string_view kind, std::string_view target, const app::Box& box,
                         std::string_view label, bool marked) {
  if (app::list_row(ui_, kind, target, box, label, marked)) {
    report({.kind = std::string(kind), .target = std::string(target)});
  }
}

void InterfacePanel::slide(std::string_view target, const app::Box& box, double value,
                           double start) {
  if (const std::optional<double> moved = app::slider(ui_, target, box, value, start)) {
    report({.kind = "slide", .target = std::string(target), .value = *moved});
  }
}

void InterfacePanel::press(std::string_view kind, std::string_view target, const app::Box& box,
                           std::string_view label) {
  if (app::small_button(ui_, kind, target, box, label)) {
    report({.kind = std::string(kind), .target = std::string(target)});
  }
}

float InterfacePanel::begin_scroll(const app::Box& box, float rows_height) {
  ImGui::SetCursorScreenPos({box.x, box.y});
  ImGui::BeginChild("scroll", {box.width, box.height});
  const bool scrolls = rows_height > box.height;
  return box.width - (scrolls ? ImGui::GetStyle().ScrollbarSize : 0);
}

void InterfacePanel::end_scroll() { ImGui::EndChild(); }

}  // namespace promenade::study
