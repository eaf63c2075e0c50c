// The tree of a ModelView, and the names of the clusters, which can be changed in place.
#include "app/cluster_colours.h"
#include "app/model_tree.h"
#include "app/model_view.h"

namespace promenade::app {
namespace {

constexpr float field_height = 28;  // at 1280 x 720

}  // namespace

void ModelView::draw_tree(const Ui& ui) {
  const Box stage = ui.layout.stage();
  const float inset = ui.layout.size(12);
  const Box inner{stage.x + inset, stage.y + inset, stage.width - 2 * inset,
                  stage.height - 2 * inset};
  const auto cut = draw_model_tree(ui, editor_, inner, [&](const Box& names, float row) {
    row_ = row;
    draw_names(ui, names);
  });
  if (cut) {
    editor_.cut_at(*cut);
    saved_ = {};
  }
  if (editor_.leaves().empty())
    draw_text(ui.look.fonts.reading, inner, ui.look.palette.quiet, "No pair is left",
              Align::centre);
}

void ModelView::draw_names(const Ui& ui, const Box& box) {
  for (int c = 0; c < static_cast<int>(editor_.names().size()); ++c) {
    const ClusterPlace place = place_of_cluster(ui, editor_, c, box, row_);
    const Rgb colour = cluster_colour(c);
    fill(place.bar, colour);
    if (c == renamed_) continue;
    if (editor_.model() && pressed_area(ui, "rename", std::to_string(c), place.name)) {
      renamed_ = c;
      text_ = editor_.names()[static_cast<std::size_t>(c)];
      page_.focus().write_in("write", "name");
      continue;
    }
    draw_line(ui.look.fonts.bold, place.name, colour, editor_.names()[static_cast<std::size_t>(c)]);
  }
  if (renamed_ >= 0) draw_field(ui, box);
}

void ModelView::draw_field(const Ui& ui, const Box& box) {
  double sum = 0;
  int count = 0;
  for (std::size_t i = 0; i < editor_.leaves().size(); ++i) {
    if (editor_.cluster()[i] != renamed_) continue;
    sum += editor_.layout().rows[i];
    ++count;
  }
  if (count == 0) {
    renamed_ = -1;
    return;
  }
  const float high = ui.layout.size(field_height);
  const Box middle = tree_row(box, sum / count, row_);
  bool entered = false;
  text_field(ui, "write", "name",
             {box.x + ui.layout.size(10), middle.middle_y() - high / 2,
              box.width - ui.layout.size(12), high},
             text_, {.hint = "name", .entered = &entered});
  const bool left = !entered && !page_.focus().on("write", "name");
  if (key_pressed(ImGuiKey_Escape, false)) {
    page_.focus().use_escape();
    renamed_ = -1;
  } else if (entered || left) {
    if (!text_.empty()) editor_.rename(renamed_, text_);
    saved_ = {};
    renamed_ = -1;
    if (entered) page_.focus().leave();
  }
}

}  // namespace promenade::app
