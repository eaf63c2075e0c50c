// The list of labels ([N] 6): every motion of the set by its name; one click shows it. The
// simplest interface, and the one that others are compared with.
#include "app/label_list.h"
#include "app/registry.h"
#include "app/shelf_view.h"
#include "study/utf8.h"

namespace promenade::app {
namespace {

using study::ControlInput;
using study::InterfacePanel;
using study::InterfaceState;

std::vector<ControlInput> simulate(const InterfaceState& state, study::Rng& rng) {
  const auto& labels = static_cast<const Labels&>(state);
  std::vector<ControlInput> picks;
  for (int i = 0; i < labels.shelf().set().size(); ++i) {
    if (i == labels.picked()) continue;
    picks.push_back(
        {.kind = "pick", .target = std::string(labels.shelf().target_of({.example = i}))});
  }
  rng.shuffle(picks);
  if (picks.size() > 4) picks.resize(4);  // nobody considers a whole list at once
  labels.shelf().propose(picks, rng);
  return picks;
}

struct Extent {
  int lines = 0, rows = 0;
  int from = -1;  // the row that the arrow keys go on from; -1: none
};

// The keyboard is on a row, or else on the one that is shown.
Extent extent_of(const Labels& labels, const Lines& lines, const Focus& focus) {
  Extent extent;
  lines.visit([&](const ShortLine&) { ++extent.lines; },
              [&](int cycle, std::string_view) {
                const Item item{.example = cycle};
                const bool here = focus.on("pick", labels.shelf().target_of(item));
                if (here || (cycle == labels.picked() && !focus.on_kind("pick"))) {
                  extent.from = extent.rows;
                }
                ++extent.lines;
                ++extent.rows;
              });
  return extent;
}

// Which row the arrow keys lead to; -1: none was pressed.
int row_by_key(const Extent& extent) {
  const int row = extent.from;
  if (extent.rows == 0) return -1;
  if (key_pressed(ImGuiKey_DownArrow)) return std::min(row + 1, extent.rows - 1);
  if (key_pressed(ImGuiKey_UpArrow)) return std::max(row - 1, 0);
  if (ImGui::GetIO().WantTextInput) return -1;  // the keys of the field
  if (key_pressed(ImGuiKey_Home)) return 0;
  if (key_pressed(ImGuiKey_End)) return extent.rows - 1;
  return -1;
}

// A slider, the stage and the name of a bookmark have the keys to themselves.
bool keys_are_elsewhere(const Labels& labels, const Focus& focus) {
  return focus.on_kind("share") || focus.on_kind("scrub") || focus.on_kind("stage") ||
         labels.shelf().edited() > 0;
}

// The arrow keys show a row, and the keyboard goes along if it was on one.
void go_to_row(const Labels& labels, InterfacePanel& panel, float y, int cycle) {
  const std::string_view target = labels.shelf().target_of({.example = cycle});
  Focus& focus = panel.ui().focus;
  if (focus.on_kind("pick")) focus.go_on("pick", target);
  if (cycle != labels.picked()) panel.report({.kind = "pick", .target = std::string(target)});
  ImGui::SetScrollFromPosY(y - ImGui::GetWindowPos().y, 0.5f);
}

void draw_heading(InterfacePanel& panel, const Box& box, std::string_view text) {
  const float inset = panel.size(4);
  panel.line(panel.look().fonts.bold, {box.x + inset, box.y, box.width - 2 * inset, box.height},
             panel.look().palette.quiet, text);
  fill({box.x, box.bottom() - panel.size(1), box.width, panel.size(1)}, panel.look().palette.line);
}

void draw_row(const Labels& labels, InterfacePanel& panel, const Box& box, int cycle,
              std::string_view label) {
  const Item item{.example = cycle};
  const std::string_view target = labels.shelf().target_of(item);
  if (list_row(panel.ui(), "pick", target, box, label, cycle == labels.picked())) {
    report_press(labels.shelf(), item, "pick", panel);
  }
}

void draw_list(const Labels& labels, InterfacePanel& panel, const Box& box) {
  const Lines lines(labels, panel);
  const Extent extent = extent_of(labels, lines, panel.ui().focus);
  const float height = panel.size(32);
  const float width = panel.begin_scroll(box, height * static_cast<float>(extent.lines));
  const ImVec2 origin = ImGui::GetCursorScreenPos();
  const bool keys = !panel.ui().inert && !keys_are_elsewhere(labels, panel.ui().focus);
  const int wanted = keys ? row_by_key(extent) : -1;
  Box line{origin.x, origin.y, width, height};
  int row = 0;
  lines.visit(
      [&](const ShortLine& heading) {
        draw_heading(panel, line, heading.text());
        line.y += height;
      },
      [&](int cycle, std::string_view label) {
        draw_row(labels, panel, line, cycle, label);
        if (row++ == wanted && wanted != extent.from) go_to_row(labels, panel, line.y, cycle);
        line.y += height;
      });
  if (extent.rows == 0) {
    panel.line(panel.look().fonts.text, line, panel.look().palette.quiet,
               panel.text("interface.labels.none"), Align::centre);
  }
  panel.end_scroll();
}

// What is typed while no field has the keyboard searches, too: the field of the filter takes
// over with the first letter. A space alone presses what has the keyboard.
void type_to_search(InterfacePanel& panel, std::string& filter) {
  ImGuiIO& io = ImGui::GetIO();
  Focus& focus = panel.ui().focus;
  if (io.WantTextInput || panel.ui().inert) return;
  for (const ImWchar letter : io.InputQueueCharacters) {
    const bool writes = letter > ' ' || (letter == ' ' && focus.on("filter", "list"));
    if (!writes || letter == 0x7F) continue;
    study::append_character(filter, letter);
    focus.write_in("filter", "list");
  }
  filter = study::first_characters(filter, longest_filter);
  if (key_pressed(ImGuiKey_Backspace)) study::drop_last_character(filter);
  // The field would enter them a second time.
  if (focus.on("filter", "list")) io.InputQueueCharacters.resize(0);
}

// Escape shows the whole list again, before it is a pause.
bool shows_all_by_key(const Labels& labels, InterfacePanel& panel) {
  Focus& focus = panel.ui().focus;
  const bool ours = !ImGui::GetIO().WantTextInput || focus.on("filter", "list");
  if (panel.ui().inert || !ours || labels.filter().empty()) return false;
  if (!key_pressed(ImGuiKey_Escape, false)) return false;
  focus.use_escape();
  panel.report({.kind = "show_all", .target = "list"});
  return true;
}

void draw_filter(const Labels& labels, InterfacePanel& panel, const Box& box) {
  const float clear = labels.filter().empty() ? 0 : box.height;
  std::string text = labels.filter();
  const Box field{box.x, box.y, box.width - clear, box.height};
  const std::string& hint = panel.text("interface.labels.filter");
  const bool all = shows_all_by_key(labels, panel);
  type_to_search(panel, text);
  text_field(panel.ui(), "filter", "list", field, text,
             {.hint = hint.c_str(), .most = longest_filter});
  if (!all && text != labels.filter()) {
    panel.report({.kind = "filter", .target = "list", .text = text});
  }
  if (clear > 0) {
    panel.press("show_all", "list", {field.right(), box.y, clear, box.height}, Icon::close);
  }
}

void draw(const InterfaceState& state, InterfacePanel& panel) {
  const auto& labels = static_cast<const Labels&>(state);
  const Box upper = upper_part(panel);
  const float height = panel.size(36);
  draw_filter(labels, panel, {upper.x, upper.y, upper.width, height});
  const float top = upper.y + height + panel.size(4);
  draw_list(labels, panel, {upper.x, top, upper.width, upper.bottom() - top});
  draw_shelf(labels.shelf(), panel);
}

const InterfaceEntry entry{{
    .name = "labels",
    .sentence = "A list of the names of all motions; a click or the arrow keys show one at once. "
                "Bookmarks and mixtures keep and blend what was found.",
    .parameters = {{.name = "sorted",
                    .standard = true,
                    .choices = {},
                    .sentence = "true: by name; false: in the order of the motion set"},
                   {.name = "groups",
                    .standard = std::string("auto"),
                    .choices = {"auto", "style", "alphabet", "none"},
                    .sentence =
                        "headings: for each style and its variants, for each letter, or one; auto: "
                        "styles if they have variants, else letters if there are more than 20"}},
    .texts = with_shelf_texts({"interface.labels.title", "interface.labels.hint",
                               "interface.labels.filter", "interface.labels.none",
                               "interface.labels.count", "interface.labels.hiragana",
                               "interface.labels.katakana", "interface.labels.kanji"}),
    .start = start_as<Labels>,
    .simulate = simulate,
    .draw = draw,
}};

}  // namespace
}  // namespace promenade::app
