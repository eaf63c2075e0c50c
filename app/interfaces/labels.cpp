// The list of labels ([N] 6): every motion of the set by its name; one click shows it. The
// simplest interface, and the one that others are compared with.
#include "app/list_groups.h"
#include "app/registry.h"
#include "app/shelf_view.h"
#include "app/utf8.h"

namespace promenade::app {
namespace {

using study::Applied;
using study::ControlInput;
using study::InterfacePanel;
using study::InterfaceState;

constexpr int longest_filter = 30;  // characters

class Labels final : public InterfaceState {
 public:
  explicit Labels(const study::InterfaceContext& context)
      : start_(context.start),
        shelf_(context.space.set, nullptr, context.start),
        sorted_(std::get<bool>(context.parameters.at("sorted"))),
        groups_(style_groups(context.space.set)),
        grouping_(grouping_of(std::get<std::string>(context.parameters.at("groups")), groups_)) {}

  std::unique_ptr<InterfaceState> clone() const override { return std::make_unique<Labels>(*this); }

  Applied apply(const ControlInput& input) override {
    if (input.kind == "pick") {
      const int cycle = motion::find_cycle(shelf_.set(), input.target);
      if (cycle < 0) return Applied::refused;
      shelf_.go({.example = cycle});
      return Applied::done;
    }
    if (input.kind == "filter" || input.kind == "show_all") return search(input);
    return shelf_.apply(input, {study::weights_of(*this, input.t_us)});
  }

  void weights(std::int64_t, Eigen::VectorXd& weights) const override {
    if (!shelf_.weights(weights)) weights = start_;
  }

  std::vector<ControlInput> settings() const override {
    std::vector<ControlInput> settings;
    shelf_.add_settings(settings);
    if (picked() >= 0) {
      settings.push_back(
          {.kind = "pick", .target = std::string(shelf_.target_of({.example = picked()}))});
    }
    return settings;
  }

  const Shelf& shelf() const { return shelf_; }
  int picked() const { return shelf_.current().example; }  // -1: none
  bool sorted() const { return sorted_; }
  Grouping grouping() const { return grouping_; }
  int group(int cycle) const { return groups_[static_cast<std::size_t>(cycle)]; }
  void restored(const InterfaceState& left, const Eigen::VectorXd&, std::int64_t) override {
    filter_ = static_cast<const Labels&>(left).filter_;
  }

  const std::string& filter() const { return filter_; }

 private:
  Applied search(const ControlInput& input) {
    const bool fits = first_characters(input.text, longest_filter) == input.text;
    if (input.target != "list" || !fits) return Applied::refused;
    filter_ = input.kind == "filter" ? input.text : "";
    return Applied::aside;
  }

  Eigen::VectorXd start_;
  Shelf shelf_;
  bool sorted_;
  std::vector<int> groups_;
  Grouping grouping_;
  std::string filter_;
};

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

// The list as it stands: its lines from the top, with headings, without what does not match.
class Lines {
 public:
  Lines(const Labels& labels, const InterfacePanel& panel)
      : labels_(labels), panel_(panel), size_(labels.shelf().set().size()) {}

  // heading(text) and row(cycle, label), in their order.
  template <typename Heading, typename Row>
  void visit(const Heading& heading, const Row& row) const {
    for (int k = 0; k < size_; ++k) {
      if (!leads(k)) continue;
      const int first = cycle(k);
      const std::size_t shared = shared_by_group(k);
      heading(heading_of(first, shared, k));
      for (int m = k; m < size_; ++m) {
        if (!shows(cycle(m)) || !together(first, cycle(m))) continue;
        row(cycle(m), after_heading(name(cycle(m)), shared));
      }
    }
  }

 private:
  int cycle(int place) const {
    return labels_.sorted() ? panel_.content().by_name[static_cast<std::size_t>(place)] : place;
  }
  std::string_view name(int cycle) const {
    return panel_.content().names[static_cast<std::size_t>(cycle)];
  }
  bool shows(int cycle) const { return matches(name(cycle), labels_.filter()); }
  bool together(int a, int b) const {
    if (labels_.grouping() == Grouping::style) return labels_.group(a) == labels_.group(b);
    return labels_.grouping() == Grouping::none || letter_of(name(a)) == letter_of(name(b));
  }
  // Is it the first of its group?
  bool leads(int place) const {
    if (!shows(cycle(place))) return false;
    for (int k = 0; k < place; ++k) {
      if (shows(cycle(k)) && together(cycle(k), cycle(place))) return false;
    }
    return true;
  }
  // Bytes of the name that all of the group begin with, also those that do not match.
  std::size_t shared_by_group(int place) const {
    if (labels_.grouping() != Grouping::style) return 0;
    const std::string_view first = name(cycle(place));
    std::size_t shared = first.size();
    for (int k = 0; k < size_; ++k) {
      if (!together(cycle(k), cycle(place))) continue;
      shared = shared_beginning(first, shared, name(cycle(k)));
    }
    return shared;
  }
  ShortLine heading_of(int cycle, std::size_t shared, int place) const {
    if (labels_.grouping() == Grouping::style) {
      return ShortLine().add(name(cycle).substr(0, shared > 0 ? shared : std::string::npos));
    }
    if (labels_.grouping() == Grouping::alphabet) return letter_heading(letter_of(name(cycle)));
    int count = 0;
    for (int k = place; k < size_; ++k) count += shows(this->cycle(k)) ? 1 : 0;
    return with_number(panel_.text("interface.labels.count"), count);
  }
  ShortLine letter_heading(std::string_view letter) const {
    if (letter == "hiragana") return ShortLine().add(panel_.text("interface.labels.hiragana"));
    if (letter == "katakana") return ShortLine().add(panel_.text("interface.labels.katakana"));
    if (letter == "kanji") return ShortLine().add(panel_.text("interface.labels.kanji"));
    return ShortLine().add(letter);
  }

  const Labels& labels_;
  const InterfacePanel& panel_;
  int size_;
};

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

void drop_last_character(std::string& text) {
  while (!text.empty()) {
    const bool within = (static_cast<unsigned char>(text.back()) & 0xC0U) == 0x80U;
    text.pop_back();
    if (!within) return;
  }
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
    append_character(filter, letter);
    focus.write_in("filter", "list");
  }
  filter = first_characters(filter, longest_filter);
  if (key_pressed(ImGuiKey_Backspace)) drop_last_character(filter);
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
    .start =
        [](const study::InterfaceContext& context) { return std::make_unique<Labels>(context); },
    .simulate = simulate,
    .draw = draw,
}};

}  // namespace
}  // namespace promenade::app
