// The tree of a ModelView: leaves, merges, the cut, and the names of the clusters.
#include <algorithm>
#include <cmath>

#include "app/cluster_colours.h"
#include "app/model_view.h"

namespace promenade::app {
namespace {

// At 1280 x 720.
constexpr float least_row = 17, field_height = 28, names_width = 190;

float widest(ImFont* font, const std::vector<std::string>& texts, float most) {
  float width = 0;
  for (const std::string& text : texts) width = std::max(width, text_width(font, text));
  return std::min(width, most);
}

}  // namespace

Box ModelView::row_box(const Box& box, double row) const {
  return {box.x, box.y + static_cast<float>(row) * row_, box.width, row_};
}

void ModelView::draw_tree(const Ui& ui) {
  const Box stage = ui.layout.stage();
  const float inset = ui.layout.size(12);
  const Box inner{stage.x + inset, stage.y + inset, stage.width - 2 * inset,
                  stage.height - 2 * inset};
  const auto leaves = static_cast<float>(std::max<std::size_t>(1, editor_.leaves().size()));
  row_ = std::max(ui.layout.size(least_row),
                  std::min(std::floor(inner.height / leaves), ui.layout.size(30)));
  ImGui::SetCursorScreenPos({inner.x, inner.y});
  ImGui::BeginChild("tree", {inner.width, inner.height}, false, ImGuiWindowFlags_NoBackground);
  const ImVec2 from = ImGui::GetCursorScreenPos();
  const bool scrolls = row_ * leaves > inner.height;
  const float width = inner.width - (scrolls ? ImGui::GetStyle().ScrollbarSize : 0);
  const float bars = ui.layout.size(26);
  const float names = std::max(ui.layout.size(names_width),
                               bars + widest(ui.look.fonts.bold, editor_.names(), 0.34f * width));
  const float left = widest(ui.look.fonts.text, editor_.leaves(), 0.45f * width) + inset;
  const Box tree{from.x + left, from.y, width - left - names, row_ * leaves};
  draw_cut(ui, tree);
  draw_leaves(ui, {from.x, from.y, left - inset, tree.height});
  draw_merges(ui, tree);
  draw_names(ui, {tree.right(), tree.y, names, tree.height});
  ImGui::SetCursorScreenPos({from.x, from.y + tree.height});
  ImGui::EndChild();
  if (editor_.leaves().empty())
    draw_text(ui.look.fonts.reading, inner, ui.look.palette.quiet, "No pair is left",
              Align::centre);
}

void ModelView::draw_leaves(const Ui& ui, const Box& box) {
  for (std::size_t i = 0; i < editor_.leaves().size(); ++i) {
    draw_line(ui.look.fonts.text, row_box(box, editor_.layout().rows[i]),
              cluster_colour(editor_.cluster()[i]), editor_.leaves()[i], Align::right);
  }
}

void ModelView::draw_merges(const Ui& ui, const Box& box) {
  const motion::Dendrogram& tree = editor_.tree();
  const std::vector<int> nodes = motion::clusters_of_nodes(tree, editor_.cluster());
  const float thick = ui.layout.size(2);
  const auto x_of = [&](double height) {
    return std::round(box.x + box.width * static_cast<float>(height / editor_.top()));
  };
  const auto y_of = [&](int node) {
    return std::round(
        row_box(box, editor_.layout().rows[static_cast<std::size_t>(node)]).middle_y());
  };
  for (std::size_t t = 0; t < tree.merges.size(); ++t) {
    const motion::Merge& merge = tree.merges[t];
    const int node = tree.leaves + static_cast<int>(t);
    const int cluster = nodes[static_cast<std::size_t>(node)];
    const Rgb colour = cluster < 0 ? ui.look.palette.quiet : cluster_colour(cluster);
    for (const int part : {merge.a, merge.b}) {
      const float from = x_of(motion::height_of(tree, part));
      fill({from, y_of(part), x_of(merge.height) + thick - from, thick}, colour);
    }
    const float one = y_of(merge.a);
    const float other = y_of(merge.b);
    fill({x_of(merge.height), std::min(one, other), thick, std::abs(one - other)}, colour);
  }
}

void ModelView::draw_cut(const Ui& ui, const Box& box) {
  if (editor_.tree().merges.empty()) return;
  const auto moved = drag_bar(ui, "slide", "cut", box, editor_.cut() / editor_.top());
  if (moved) {
    editor_.cut_at(*moved * editor_.top());
    saved_ = {};
  }
  const float x = std::round(box.x + box.width * static_cast<float>(editor_.cut() / editor_.top()));
  const float dash = ui.layout.size(7);
  for (float y = box.y; y < box.bottom(); y += 2 * dash) {
    fill({x, y, ui.layout.size(2), std::min(dash, box.bottom() - y)}, ui.look.palette.text);
  }
}

void ModelView::draw_names(const Ui& ui, const Box& box) {
  for (int c = 0; c < static_cast<int>(editor_.names().size()); ++c) {
    double first = static_cast<double>(editor_.leaves().size());
    double last = 0;
    for (std::size_t i = 0; i < editor_.leaves().size(); ++i) {
      if (editor_.cluster()[i] != c) continue;
      first = std::min(first, editor_.layout().rows[i]);
      last = std::max(last, editor_.layout().rows[i]);
    }
    const Box from = row_box(box, first);
    const Box to = row_box(box, last);
    const Rgb colour = cluster_colour(c);
    const float bar = ui.layout.size(4);
    fill({box.x + bar, from.y + 1, bar, to.bottom() - from.y - 2}, colour);
    const Box name{box.x + 3 * bar, row_box(box, (first + last) / 2).y, box.width - 4 * bar, row_};
    if (c == renamed_) continue;
    if (editor_.model() && pressed_area(ui, "rename", std::to_string(c), name)) {
      renamed_ = c;
      text_ = editor_.names()[static_cast<std::size_t>(c)];
      page_.focus().write_in("write", "name");
      continue;
    }
    draw_line(ui.look.fonts.bold, name, colour, editor_.names()[static_cast<std::size_t>(c)]);
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
  const Box middle = row_box(box, sum / count);
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
