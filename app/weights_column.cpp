// The blend weights beside the sliders ([O] 6: live, or dragged).
#include <algorithm>
#include <cmath>

#include "app/parameter_sliders_view.h"

namespace promenade::app {

using study::InterfacePanel;

namespace {

void draw_bar(const InterfacePanel& panel, const Box& box, double share) {
  const Palette& palette = panel.look().palette;
  const auto part = static_cast<float>(std::clamp(share, 0.0, 1.0));
  fill(box, palette.track);
  fill({box.x, box.y, std::round(part * box.width), box.height}, palette.created);
}

void draw_weight(const ParameterSliders& sliders, InterfacePanel& panel, const Box& row,
                 int cycle) {
  const auto i = static_cast<std::size_t>(cycle);
  const double share = sliders.weight_at(panel.now_us(), cycle);
  if (sliders.catalogue().column == WeightsColumn::draggable) {
    const std::string& target = sliders.set().cycles[i].name;
    const double settled = std::clamp(sliders.weight_at(study::settled_us, cycle), 0.0, 1.0);
    if (const auto moved = drag_bar(panel.ui(), "weight", target, row, settled)) {
      panel.report({.kind = "weight", .target = target, .value = *moved});
    }
  }
  const float bar = panel.size(4);
  panel.line(panel.look().fonts.text, {row.x, row.y, row.width, row.height - bar},
             panel.look().palette.text, panel.content().names[i]);
  draw_bar(panel, {row.x, row.bottom() - bar - panel.size(2), row.width, bar}, share);
}

}  // namespace

void draw_weights_column(const ParameterSliders& sliders, InterfacePanel& panel, const Box& box) {
  const float head = panel.size(32);
  panel.line(panel.look().fonts.text, {box.x, box.y, box.width, head}, panel.look().palette.quiet,
             panel.text("sliders.weights"));
  const float height = panel.size(24);
  const Box list{box.x, box.y + head, box.width, box.height - head};
  const auto count = static_cast<float>(sliders.set().size());
  ImGui::PushID("weights");
  const float width = panel.begin_scroll(list, height * count);
  const ImVec2 origin = ImGui::GetCursorScreenPos();
  Box row{origin.x, origin.y, width - panel.size(4), height};
  for (const int cycle : panel.content().by_name) {
    draw_weight(sliders, panel, row, cycle);
    row.y += height;
  }
  ImGui::SetCursorScreenPos({row.x, row.y});
  panel.end_scroll();
  ImGui::PopID();
}

}  // namespace promenade::app
