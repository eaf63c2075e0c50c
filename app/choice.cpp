#include "app/choice.h"

#include <fmt/format.h>

#include <algorithm>

#include "app/arrows.h"

namespace promenade::app {
namespace {

constexpr std::size_t most_rows = 10;  // of an open list; the others are scrolled to

// Where the arrow keys lead from the chosen one.
std::optional<std::size_t> chosen_by_key(std::size_t count, std::size_t chosen) {
  if (key_pressed(ImGuiKey_DownArrow)) return chosen + 1 < count ? chosen + 1 : count - 1;
  if (key_pressed(ImGuiKey_UpArrow)) return chosen > 0 && chosen < count ? chosen - 1 : 0;
  return std::nullopt;
}

std::optional<std::size_t> open_list(const Ui& ui, std::string_view target, const Box& box,
                                     std::span<const std::string> options, std::size_t chosen) {
  std::optional<std::size_t> picked;
  const float row = ui.layout.size(36);
  const float high = row * static_cast<float>(std::min(options.size(), most_rows));
  const bool above = box.bottom() + high > ImGui::GetIO().DisplaySize.y && box.y > high;
  ImGui::SetNextWindowPos({box.x, above ? box.y - high : box.bottom()});
  ImGui::SetNextWindowSize({box.width, high});
  ImGui::PushStyleColor(ImGuiCol_PopupBg, packed(ui.look.palette.on_colour));
  if (ImGui::BeginPopup("list", ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings)) {
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const float bar = options.size() > most_rows ? ImGui::GetStyle().ScrollbarSize : 0;
    for (std::size_t i = 0; i < options.size(); ++i) {
      const Box line{at.x, at.y + row * static_cast<float>(i), box.width - bar, row};
      if (list_row(ui, "choose", fmt::format("{}/{}", target, i), line, options[i], i == chosen)) {
        picked = i;
      }
    }
    if (picked || key_pressed(ImGuiKey_Escape, false)) ImGui::CloseCurrentPopup();
    ImGui::EndPopup();
  }
  ImGui::PopStyleColor();
  return picked;
}

}  // namespace

std::optional<std::size_t> choice_row(const Ui& ui, std::string_view target, const Box& box,
                                      std::span<const std::string> options, std::size_t chosen) {
  std::optional<std::size_t> picked;
  const float gap = ui.layout.size(8);
  const auto count = static_cast<float>(options.size());
  const float width = (box.width - gap * (count - 1)) / count;
  for (std::size_t i = 0; i < options.size(); ++i) {
    const Box one{box.x + static_cast<float>(i) * (width + gap), box.y, width, box.height};
    const bool pressed =
        answer_button(ui, fmt::format("{}/{}", target, i), one, options[i], i == chosen);
    if (pressed && i != chosen) picked = i;
  }
  return picked;
}

std::optional<std::size_t> drop_down(const Ui& ui, std::string_view target, const Box& box,
                                     std::span<const std::string> options, std::size_t chosen) {
  fill(box, ui.look.palette.on_colour);
  const float inset = ui.layout.size(12);
  const std::string_view shown = chosen < options.size() ? options[chosen] : std::string_view("");
  draw_line(ui.look.fonts.text, {box.x + inset, box.y, box.width - 3 * inset, box.height},
            ui.look.palette.text, shown);
  const float side = ui.layout.size(14);
  const Box end{box.right() - inset - side, box.middle_y() - 0.5f * side, side, side};
  draw_arrow(end, Arrow::unfolded, ui.look.palette.quiet, ui.layout.size(2));
  ImGui::PushID(target.data(), target.data() + target.size());
  if (tile(ui, "open", target, box)) ImGui::OpenPopup("list");
  std::optional<std::size_t> picked = open_list(ui, target, box, options, chosen);
  ImGui::PopID();
  if (picked) ui.focus.take("open", target);
  if (!picked && !options.empty() && ui.focus.on("open", target)) {
    picked = chosen_by_key(options.size(), chosen);
  }
  return picked == chosen ? std::nullopt : picked;
}

bool check_box(const Ui& ui, std::string_view target, const Box& box, std::string_view label,
               bool ticked) {
  const Palette& palette = ui.look.palette;
  const float side = ui.layout.size(22);
  const Box square{box.x, box.middle_y() - 0.5f * side, side, side};
  const bool pressed = small_button(ui, "tick", target, box, "");
  fill(square, ticked ? palette.created : palette.on_colour);
  if (ticked) {
    const float in = ui.layout.size(4);
    draw_icon({square.x + in, square.y + in, side - 2 * in, side - 2 * in}, Icon::check,
              palette.on_colour, ui.layout.size(2));
  } else {
    frame(square, palette.quiet, ui.layout.size(1));
  }
  const float inset = side + ui.layout.size(10);
  draw_line(ui.look.fonts.text, {box.x + inset, box.y, box.width - inset, box.height}, palette.text,
            label);
  return pressed;
}

}  // namespace promenade::app
