// The list of parameters that a slider can be for.
#include "app/parameter_sliders_view.h"

namespace promenade::app {

using study::InterfacePanel;

namespace {

using List = ParameterSliders::List;

class ListView {
 public:
  ListView(const ParameterSliders& sliders, InterfacePanel& panel)
      : sliders_(sliders), catalogue_(sliders.catalogue()), panel_(panel) {}

  void draw() {
    const Box& all = panel_.box();
    const float head = panel_.size(44);
    draw_head({all.x, all.y, all.width, head});
    ImGui::PushID("list");
    width_ = panel_.begin_scroll({all.x, all.y + head, all.width, all.height - head},
                                 row_height() * static_cast<float>(count_rows()));
    const ImVec2 origin = ImGui::GetCursorScreenPos();
    at_ = {origin.x, origin.y, width_, row_height()};
    for (std::size_t s = 0; s < catalogue_.sections.size(); ++s) draw_section(s);
    ImGui::SetCursorScreenPos({at_.x, at_.y});
    panel_.end_scroll();
    ImGui::PopID();
  }

 private:
  float row_height() const { return panel_.size(32); }
  int end_of(std::size_t section) const {
    const bool last = section + 1 == catalogue_.sections.size();
    return last ? static_cast<int>(catalogue_.parameters.size())
                : catalogue_.sections[section + 1].first;
  }
  std::size_t count_rows() const {
    std::size_t rows = catalogue_.parameters.size();
    for (std::size_t s = 0; s < catalogue_.sections.size(); ++s) {
      if (end_of(s) > catalogue_.sections[s].first) ++rows;
    }
    return rows;
  }

  void draw_head(const Box& box) {
    const float side = panel_.size(36);
    const float margin = 0.5f * (box.height - side);
    panel_.press("back", "list", {box.x + margin, box.y + margin, side, side}, Icon::back);
    const bool adding = sliders_.list() == List::adding;
    const Box title{box.x + panel_.size(48), box.y, box.width - panel_.size(48), box.height};
    panel_.line(panel_.look().fonts.bold, title, panel_.look().palette.text,
                panel_.text(adding ? "sliders.add_title" : "sliders.alter_title"));
  }

  void draw_section(std::size_t section) {
    const int first = catalogue_.sections[section].first;
    if (first == end_of(section)) return;
    const Box heading{at_.x + panel_.size(16), at_.y, at_.width - panel_.size(16), at_.height};
    panel_.line(panel_.look().fonts.text, heading, panel_.look().palette.quiet,
                panel_.text(catalogue_.sections[section].heading));
    at_.y += at_.height;
    for (int k = first; k < end_of(section); ++k) {
      draw_parameter(k);
      at_.y += at_.height;
    }
  }

  void draw_parameter(int k) {
    const SliderParameter& parameter = catalogue_.parameters[static_cast<std::size_t>(k)];
    const bool altered = sliders_.list() == List::altering && k == sliders_.altered();
    const bool taken = !altered && sliders_.find_slider(k) >= 0;
    if (!taken) touch_row(parameter, altered);
    if (visible_box().bottom() < at_.y || visible_box().y > at_.bottom()) return;
    const Palette& palette = panel_.look().palette;
    const Rgb gone = 0.5f * (palette.quiet + palette.panel);  // it has a slider already
    const Rgb& ink = altered ? palette.on_colour : taken ? gone : palette.text;
    Box name{at_.x + panel_.size(16), at_.y, at_.width - panel_.size(24), at_.height};
    if (catalogue_.pictograms) {
      const float side = panel_.size(28);
      const float shift = panel_.size(40);
      if (!altered) {
        draw_pictogram({name.x, at_.y + 0.5f * (at_.height - side), side, side},
                       parameter.pictogram, palette);
      }
      name.x += shift;
      name.width -= shift;
    }
    draw_parameter_name(panel_, parameter, name, ink);
  }

  // The slider's own parameter leads back to it.
  void touch_row(const SliderParameter& parameter, bool altered) {
    const bool adding = sliders_.list() == List::adding;
    const char* const kind = adding ? "add" : "alter";
    if (!list_row(panel_.ui(), kind, parameter.name, at_, "", altered)) return;
    if (altered) return panel_.report({.kind = "back", .target = "list"});
    panel_.report({.kind = kind, .target = parameter.name, .text = adding ? "" : altered_name()});
  }
  const std::string& altered_name() const {
    return catalogue_.parameters[static_cast<std::size_t>(sliders_.altered())].name;
  }

  const ParameterSliders& sliders_;
  const SliderCatalogue& catalogue_;
  InterfacePanel& panel_;
  float width_ = 0;
  Box at_;  // of the next row
};

}  // namespace

void draw_parameter_list(const ParameterSliders& sliders, InterfacePanel& panel) {
  ListView(sliders, panel).draw();
}

}  // namespace promenade::app
