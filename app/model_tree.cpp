#include "app/model_tree.h"

#include <algorithm>
#include <cmath>

#include "app/cluster_colours.h"

namespace promenade::app {
namespace {

// At 1280 x 720.
constexpr float least_row = 17, most_row = 30, names_width = 190;

float widest(ImFont* font, const std::vector<std::string>& texts, float most) {
  float width = 0;
  for (const std::string& text : texts) width = std::max(width, text_width(font, text));
  return std::min(width, most);
}

void draw_leaves(const Ui& ui, const ModelEditor& editor, const Box& box, float row) {
  for (std::size_t i = 0; i < editor.leaves().size(); ++i) {
    draw_line(ui.look.fonts.text, tree_row(box, editor.layout().rows[i], row),
              cluster_colour(editor.cluster()[i]), editor.leaves()[i], Align::right);
  }
}

void draw_merges(const Ui& ui, const ModelEditor& editor, const Box& box, float row) {
  const motion::Dendrogram& tree = editor.tree();
  const std::vector<int> nodes = motion::clusters_of_nodes(tree, editor.cluster());
  const float thick = ui.layout.size(2);
  const auto x_of = [&](double height) {
    return std::round(box.x + box.width * static_cast<float>(height / editor.top()));
  };
  const auto y_of = [&](int node) {
    return std::round(
        tree_row(box, editor.layout().rows[static_cast<std::size_t>(node)], row).middle_y());
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

std::optional<double> draw_cut(const Ui& ui, const ModelEditor& editor, const Box& box) {
  if (editor.tree().merges.empty()) return std::nullopt;
  const auto moved = drag_bar(ui, "slide", "cut", box, editor.cut() / editor.top());
  const double cut = moved ? *moved * editor.top() : editor.cut();
  const float x = std::round(box.x + box.width * static_cast<float>(cut / editor.top()));
  const float dash = ui.layout.size(7);
  for (float y = box.y; y < box.bottom(); y += 2 * dash) {
    fill({x, y, ui.layout.size(2), std::min(dash, box.bottom() - y)}, ui.look.palette.text);
  }
  return moved ? std::optional(cut) : std::nullopt;
}

}  // namespace

Box tree_row(const Box& box, double row, float high) {
  return {box.x, box.y + static_cast<float>(row) * high, box.width, high};
}

ClusterPlace place_of_cluster(const Ui& ui, const ModelEditor& editor, int cluster,
                              const Box& names, float row) {
  double first = static_cast<double>(editor.leaves().size());
  double last = 0;
  for (std::size_t i = 0; i < editor.leaves().size(); ++i) {
    if (editor.cluster()[i] != cluster) continue;
    first = std::min(first, editor.layout().rows[i]);
    last = std::max(last, editor.layout().rows[i]);
  }
  const Box from = tree_row(names, first, row);
  const Box to = tree_row(names, last, row);
  const float bar = ui.layout.size(4);
  return {
      {names.x + bar, from.y + 1, bar, to.bottom() - from.y - 2},
      {names.x + 3 * bar, tree_row(names, (first + last) / 2, row).y, names.width - 4 * bar, row}};
}

std::optional<double> draw_model_tree(
    const Ui& ui, const ModelEditor& editor, const Box& box,
    const std::function<void(const Box& names, float row)>& draw_names) {
  const auto leaves = static_cast<float>(std::max<std::size_t>(1, editor.leaves().size()));
  const float row = std::max(ui.layout.size(least_row),
                             std::min(std::floor(box.height / leaves), ui.layout.size(most_row)));
  ImGui::SetCursorScreenPos({box.x, box.y});
  ImGui::BeginChild("tree", {box.width, box.height}, false, ImGuiWindowFlags_NoBackground);
  const ImVec2 from = ImGui::GetCursorScreenPos();
  const bool scrolls = row * leaves > box.height;
  const float width = box.width - (scrolls ? ImGui::GetStyle().ScrollbarSize : 0);
  const float bars = ui.layout.size(26);
  const float inset = ui.layout.size(12);
  const float most = 0.34f * width;
  const float names = std::max(std::min(ui.layout.size(names_width), most),
                               bars + widest(ui.look.fonts.bold, editor.names(), most));
  const float left = widest(ui.look.fonts.text, editor.leaves(), 0.45f * width) + inset;
  const Box tree{from.x + left, from.y, width - left - names, row * leaves};
  const auto cut = draw_cut(ui, editor, tree);
  draw_leaves(ui, editor, {from.x, from.y, left - inset, tree.height}, row);
  draw_merges(ui, editor, tree, row);
  draw_names({tree.right(), tree.y, names, tree.height}, row);
  ImGui::SetCursorScreenPos({from.x, from.y + tree.height});
  ImGui::EndChild();
  return cut;
}

void draw_cluster_names(const Ui& ui, const ModelEditor& editor, const Box& names, float row) {
  for (int c = 0; c < static_cast<int>(editor.names().size()); ++c) {
    const ClusterPlace place = place_of_cluster(ui, editor, c, names, row);
    fill(place.bar, cluster_colour(c));
    draw_line(ui.look.fonts.bold, place.name, cluster_colour(c),
              editor.names()[static_cast<std::size_t>(c)]);
  }
}

}  // namespace promenade::app
