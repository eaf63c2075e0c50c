#include "app/shelf_view.h"

#include <cmath>

namespace promenade::app {
namespace {

using study::InterfacePanel;

constexpr float row_720 = 36;

Box part_of_row(const InterfacePanel& panel, const Box& row, float from, float width) {
  return {row.x + panel.size(from), row.y, panel.size(width), row.height};
}

void quiet_line(InterfacePanel& panel, const Box& box, std::string_view text) {
  panel.line(panel.look().fonts.text, box, panel.look().palette.quiet, text);
}

// Numbered squares; the one that is shown has a frame in the colour of what is shown.
void draw_bookmark(const Shelf& shelf, InterfacePanel& panel, const Box& chip,
                   const Bookmark& bookmark) {
  const Palette& palette = panel.look().palette;
  const Item item{.bookmark = bookmark.number};
  const auto within = [&](float inset_720) -> Box {
    const float inset = panel.size(inset_720);
    return {chip.x + inset, chip.y + inset, chip.width - 2 * inset, chip.height - 2 * inset};
  };
  if (shelf.current() == item) fill(chip, palette.current);
  if (shelf.current() == item) fill(within(2), palette.on_colour);
  fill(within(shelf.current() == item ? 3 : 1), palette.bookmark);
  draw_text(panel.look().fonts.bold, chip, palette.on_colour, digit_of(bookmark), Align::centre);
  if (pressed_area(panel.ui(), "goto", digit_of(bookmark), chip)) {
    report_press(shelf, item, "", panel);
  }
}

void draw_bookmarks(const Shelf& shelf, InterfacePanel& panel, const Box& row) {
  float from = 0;
  for (const Bookmark& bookmark : shelf.bookmarks()) {
    Box chip = part_of_row(panel, row, from, 30);
    chip.y += std::round(0.5f * (row.height - chip.width));
    chip.height = chip.width;
    draw_bookmark(shelf, panel, chip, bookmark);
    from += 31;
  }
  if (shelf.bookmarks().size() == most_bookmarks) return;
  const Box add = part_of_row(panel, row, 400 - 120, 120);
  panel.press("bookmark", "", add, panel.text("interface.shelf.add"));
}

void draw_name_field(const Shelf& shelf, InterfacePanel& panel, const Box& box) {
  const Bookmark& bookmark = *shelf.find_bookmark(shelf.edited());
  const std::string_view target = digit_of(bookmark);
  // The field that has just been opened is the one to write in.
  if (panel.ui().focus.on("rename", target) && !ImGui::IsAnyItemActive()) {
    ImGui::SetKeyboardFocusHere();
  }
  std::string name = bookmark.name;
  bool entered = false;
  const std::string& hint = panel.text("interface.shelf.name_hint");
  if (text_field(panel.ui(), "rename", target, box, name,
                 {.hint = hint.c_str(), .most = longest_bookmark_name, .entered = &entered})) {
    panel.report({.kind = "rename", .target = std::string(target), .text = name});
  }
  const bool left = panel.ui().focus.on("rename", target) && key_pressed(ImGuiKey_Escape, false);
  if (entered || left) panel.report({.kind = "edit", .target = ""});
}

bool is_mixed(const Shelf& shelf, const Item& item) {
  for (const Ingredient& part : shelf.mixture()) {
    if (part.item == item) return true;
  }
  return false;
}

// What can be done with an example or a bookmark beside going there.
void draw_offer(const Shelf& shelf, InterfacePanel& panel, const Box& box) {
  const Item item = shelf.offered();
  const std::string_view target = shelf.target_of(item);
  const Box name{box.x, box.y, box.width - panel.size(row_720), panel.size(row_720)};
  if (shelf.edited() > 0) {
    draw_name_field(shelf, panel, name);
  } else {
    panel.line(panel.look().fonts.bold, name, panel.look().palette.text,
               name_of(shelf, item, panel).text());
  }
  panel.press("offer", "", part_of_row(panel, name, 400 - row_720, row_720), Icon::close);
  const Box buttons{box.x, name.bottom() + panel.size(4), box.width, panel.size(row_720)};
  const auto button_at = [&](int place, std::string_view kind, std::string_view of,
                             std::string_view key) {
    const Box at = part_of_row(panel, buttons, 136 * static_cast<float>(place), 128);
    frame(at, panel.look().palette.line, panel.size(1));
    const bool pressed = small_button(panel.ui(), kind, of, at, panel.text(key));
    if (pressed) panel.report({.kind = std::string(kind), .target = std::string(of)});
    return pressed;
  };
  if (is_mixed(shelf, item)) {
    quiet_line(panel, part_of_row(panel, buttons, 0, 128), panel.text("interface.shelf.mixed"));
  } else {
    button_at(0, "mix", target, "interface.shelf.mix");
  }
  if (const Bookmark* bookmark = shelf.find_bookmark(item.bookmark)) {
    const std::string_view number = digit_of(*bookmark);
    if (button_at(1, "edit", number, "interface.shelf.rename")) {
      panel.ui().focus.take("rename", number);
    }
    button_at(2, "remove", number, "interface.shelf.remove");
  } else if (shelf.bookmarks().size() < most_bookmarks) {
    button_at(1, "bookmark", target, "interface.shelf.keep");
  }
}

void draw_share(const Shelf& shelf, InterfacePanel& panel, const Ui& ui, const Box& row,
                const Ingredient& part) {
  const std::string_view target = shelf.target_of(part.item);
  const double sum = shelf.share_sum();
  const float end = row.width - panel.size(row_720);
  panel.line(panel.look().fonts.text, part_of_row(panel, row, 0, 124), panel.look().palette.text,
             name_of(shelf, part.item, panel).text());
  if (shelf.mixture().size() > 1) {
    const float from = panel.size(132);
    const float percent = panel.size(52);
    const Box slide{row.x + from, row.y, end - from - percent, row.height};
    if (const auto moved = slider(ui, "share", target, slide, part.share, Ingredient{}.share)) {
      panel.report({.kind = "share", .target = std::string(target), .value = *moved});
    }
    const double share = sum > 0 ? part.share / sum : 0;
    const Box at{slide.right(), row.y, percent, row.height};
    ShortLine line;
    line.add(static_cast<int>(std::lround(100 * share))).add("%");
    draw_text(panel.look().fonts.text, at, panel.look().palette.quiet, line.text(), Align::right);
  }
  panel.press("unmix", target, {row.x + end, row.y, panel.size(row_720), row.height}, Icon::close);
}

std::string_view note_of(const Shelf& shelf, const InterfacePanel& panel) {
  const std::size_t parts = shelf.mixture().size();
  if (parts == 0) return panel.text("interface.shelf.hint");
  if (parts == 1) return panel.text("interface.shelf.one");
  const bool nothing = shelf.shown() == Shelf::Shown::mixture && shelf.share_sum() <= 0;
  return nothing ? std::string_view(panel.text("interface.shelf.all_zero")) : std::string_view();
}

void draw_mixture(const Shelf& shelf, InterfacePanel& panel, const Box& box) {
  const std::string_view note = note_of(shelf, panel);
  const float note_height = note.empty() ? 0 : panel.size(row_720);
  const Box list{box.x, box.y, box.width, box.height - note_height};
  const float height = panel.size(row_720);
  // While something else is shown the mixture stands back.
  Look look = panel.look();
  if (shelf.shown() != Shelf::Shown::mixture) look.palette.created = look.palette.line;
  const Ui ui{look, panel.ui().layout, panel.ui().widgets, panel.ui().focus, panel.ui().inert};
  if (!shelf.mixture().empty()) {
    ImGui::PushID("mixture");
    const float rows = height * static_cast<float>(shelf.mixture().size());
    Box row{0, 0, panel.begin_scroll(list, rows), height};
    const ImVec2 origin = ImGui::GetCursorScreenPos();
    row.x = origin.x;
    row.y = origin.y;
    for (const Ingredient& part : shelf.mixture()) {
      draw_share(shelf, panel, ui, row, part);
      row.y += height;
    }
    panel.end_scroll();
    ImGui::PopID();
  }
  const float used = shelf.mixture().size() == 1 ? height
                     : shelf.mixture().empty()   ? 0
                                                 : list.height;
  if (!note.empty()) quiet_line(panel, {box.x, box.y + used, box.width, panel.size(row_720)}, note);
}

}  // namespace

std::string_view digit_of(const Bookmark& bookmark) {
  constexpr std::string_view digits = "123456789";
  return digits.substr(static_cast<std::size_t>(bookmark.number) - 1, 1);
}

std::vector<std::string> with_shelf_texts(std::vector<std::string> own) {
  own.insert(own.end(), shelf_texts.begin(), shelf_texts.end());
  return own;
}

ShortLine name_of(const Shelf& shelf, const Item& item, const InterfacePanel& panel) {
  if (const Bookmark* bookmark = shelf.find_bookmark(item.bookmark)) {
    if (!bookmark->name.empty()) return ShortLine().add(bookmark->name);
    return with_number(panel.text("interface.shelf.named"), bookmark->number);
  }
  return ShortLine().add(panel.content().captions.names[static_cast<std::size_t>(item.example)]);
}

void report_press(const Shelf& shelf, const Item& item, std::string_view kind,
                  InterfacePanel& panel) {
  const std::string target(shelf.target_of(item));
  if (shelf.current() == item) {
    panel.report({.kind = "offer", .target = target});
  } else if (item.bookmark > 0) {
    panel.report({.kind = "goto", .target = target.substr(1)});
  } else {
    panel.report({.kind = std::string(kind), .target = target});
  }
}

Box upper_part(const InterfacePanel& panel) {
  const float inset = panel.size(8);
  return {panel.box().x + inset, panel.box().y + inset, panel.size(400), panel.size(400)};
}

void draw_shelf(const Shelf& shelf, InterfacePanel& panel) {
  const Box upper = upper_part(panel);
  const Box row{upper.x, upper.bottom() + panel.size(8), upper.width, panel.size(row_720)};
  draw_bookmarks(shelf, panel, row);
  const float top = row.bottom() + panel.size(4);
  const Box rest{upper.x, top, upper.width, panel.box().bottom() - panel.size(4) - top};
  if (shelf.offered().empty()) {
    draw_mixture(shelf, panel, rest);
  } else {
    draw_offer(shelf, panel, rest);
  }
}

}  // namespace promenade::app
