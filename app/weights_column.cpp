// The blend weights beside the sliders ([O] 6: live, or dragged).
#include <algorithm>
#include <cmath>

#include "app/parameter_sliders_view.h"

namespace promenade::app {

using study::InterfacePanel;

namespace {

// The bar lies under the name, in a tone that leaves it readable.
void draw_bar(const InterfacePanel& panel, const Box& box, double share) {
  const Palette& palette = panel.look().palette;
  const auto part = static_cast<float>(std::clamp(share, 0.0, 1.0));
  fill(box, palette.hover);
  fill({box.x, box.y, std::round(part * box.width), box.height},
       Rgb(0.4f * palette.created + 0.6f * palette.panel));
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
  draw_bar(panel, {row.x, row.y, row.width, row.height - panel.size(2)}, share);
  const float inset = panel.size(4);
  panel.line(panel.look().fonts.text,
             {row.x + inset, row.y, row.width - 2 * inset, row.height - panel.size(2)},
             panel.look().palette.text, panel.content().captions.names[i]);
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
  // Beside the bar that scrolls there is no room to give away.
  const float margin = width < box.width ? 0 : panel.size(8);
  Box row{origin.x, origin.y, width - margin, height};
  for (const int cycle : panel.content().captions.by_name) {
    draw_weight(sliders, panel, row, cycle);
    row.y += height;
  }
  ImGui::SetCursorScreenPos({row.x, row.y});
  panel.end_scroll();
  ImGui::PopID();
}

}  // namespace promenade::app
