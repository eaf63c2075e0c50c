#include "app/desk/edit/edit_form.h"

#include <fmt/format.h>

#include <algorithm>

#include "app/arrows.h"
#include "app/scroll_area.h"

namespace promenade::app {
namespace {

using study::TomlPath;

constexpr float label_share = 0.4f;
constexpr float indent = 14;

const std::string& label_of(const FormPass& pass, const EditField& field) {
  return field.words.empty() ? field.key : pass.words("edit." + field.words + ".label");
}

const std::string& help_of(const FormPass& pass, const EditField& field) {
  return field.words.empty() ? field.own_help : pass.words("edit." + field.words + ".help");
}

// What an item is, beside its name: the kind of a task, when a questionnaire is asked.
std::string summary_of(const FormPass& pass, const FormRow& row) {
  const study::TomlValue* item = study::value_at(pass.root(), row.path);
  for (const char* key : {"kind", "when", "type"}) {
    const study::TomlValue* value = item != nullptr ? study::find_key(*item, key) : nullptr;
    if (value != nullptr && value->text != row.title) return value->text;
  }
  if (row.field.choices != "target") return "";
  const std::string source = shown_source(pass.root(), row.path);
  return source == row.title ? "" : source;
}

bool has_control(const Ui& ui, const std::string& target) {
  for (const char* kind : {"type", "open", "tick", "press"}) {
    if (ui.focus.on(kind, target) || ui.focus.on_first(kind, target + "/")) return true;
  }
  return false;
}

const Rgb& colour_of(const Palette& palette, Severity severity) {
  return severity == Severity::error ? palette.alarm : palette.pilot;
}

}  // namespace

void EditForm::go_to(const TomlPath& path) {
  reveal(path);
  wanted_ = path;
}

void EditForm::reveal(const TomlPath& path) {
  if (section_of(path) != section_) show(section_of(path));
  unfold(path, open_);
}

void EditForm::show(std::size_t section) {
  section_ = section;
  focused_.clear();
  controls_.leave();
}

void EditForm::draw(const Ui& ui, const study::Texts& words, const Box& box,
                    const FormScene& scene) {
  const FormPass pass{ui, words, scene};
  const float names = ui.layout.size(140);
  const float foot = ui.layout.size(72);
  const float between = ui.layout.size(12);
  draw_sections(pass, {box.x, box.y, names, box.height - foot});
  draw_rows(pass, {box.x + names + between, box.y, box.width - names - between,
                   box.height - foot - between});
  draw_help(pass, {box.x, box.bottom() - foot, box.width, foot});
}

// Each with a mark where something is wrong in it.
void EditForm::draw_sections(const FormPass& pass, const Box& box) {
  const Palette& palette = pass.ui.look.palette;
  const auto& sections = edit_sections();
  const float high = pass.ui.layout.size(40);
  for (std::size_t i = 0; i < sections.size(); ++i) {
    const Box row{box.x, box.y + static_cast<float>(i) * high, box.width, high};
    const std::string& label = pass.words("edit.section." + sections[i].name);
    if (list_row(pass.ui, "section", sections[i].name, row, label, i == section_)) show(i);
    const PlacedProblem* worst = nullptr;
    for (const PlacedProblem& one : pass.scene.problems) {
      if (one.line == 0 || section_of(one.path) != i) continue;
      if (worst == nullptr || one.problem.severity == Severity::error) worst = &one;
    }
    if (worst == nullptr) continue;
    const float wide = pass.ui.layout.size(6);
    fill({row.x, row.y, wide, row.height}, colour_of(palette, worst->problem.severity));
  }
}

void EditForm::draw_rows(const FormPass& pass, const Box& box) {
  fill(box, pass.ui.look.palette.panel);
  const std::vector<FormRow> rows =
      form_rows(pass.root(), pass.scene.registry, edit_sections()[section_], open_);
  const float bar = ImGui::GetStyle().ScrollbarSize;
  const float edge = pass.ui.layout.size(12);
  float high = edge;
  for (const FormRow& row : rows) high += row_height(pass, row, box.width - bar - 2 * edge);
  focused_.clear();
  help_hovered_ = false;
  help_.clear();
  scrolled(("rows " + edit_sections()[section_].name).c_str(), box, high, [&](const Box& inner) {
    Box line{inner.x + edge, inner.y + edge, box.width - bar - 2 * edge, 0};
    for (const FormRow& row : rows) {
      line.height = row_height(pass, row, line.width);
      draw_row(pass, row, line);
      line.y += line.height;
    }
  });
  wanted_.reset();
}

float EditForm::row_height(const FormPass& pass, const FormRow& row, float width) const {
  const float problems = problems_height(pass, row, width);
  switch (row.kind) {
    case FormRow::Kind::field:
      return std::max(controls_.height(pass, row), pass.ui.layout.size(44)) +
             pass.ui.layout.size(12) + problems;
    case FormRow::Kind::list:
      return pass.ui.layout.size(40) + problems;
    case FormRow::Kind::item:
      return pass.ui.layout.size(44) + problems;
    case FormRow::Kind::add:
      return pass.ui.layout.size(56);
  }
  return 0;
}

void EditForm::draw_row(const FormPass& pass, const FormRow& row, const Box& box) {
  come(pass, row);
  const float in = static_cast<float>(row.depth) * pass.ui.layout.size(indent);
  const Box inner{box.x + in, box.y, box.width - in, box.height};
  for (int i = 0; i < row.depth; ++i) {
    const float x = box.x + static_cast<float>(i) * pass.ui.layout.size(indent);
    fill({x + pass.ui.layout.size(5), box.y, pass.ui.layout.size(1), box.height},
         pass.ui.look.palette.line);
  }
  note(pass, row, inner);
  switch (row.kind) {
    case FormRow::Kind::field:
      return draw_field(pass, row, inner);
    case FormRow::Kind::list:
      return draw_list(pass, row, inner);
    case FormRow::Kind::item:
      return draw_item(pass, row, inner);
    case FormRow::Kind::add:
      return draw_add(pass, row, inner);
  }
}

// Brings the keyboard to the row that was asked for: its own, or the one that holds the value.
void EditForm::come(const FormPass& pass, const FormRow& row) {
  if (!wanted_ || wanted_->empty()) return;
  const bool field = row.kind == FormRow::Kind::field && study::begins_with(*wanted_, row.path) &&
                     row.field.kind != FieldKind::source;
  const bool item = row.kind == FormRow::Kind::item && *wanted_ == row.path;
  if (field && !row.path.empty()) {
    const auto [kind, target] = EditControls::stop_of(pass, row);
    pass.ui.focus.write_in(kind, target);
    wanted_.reset();
  } else if (item) {
    pass.ui.focus.write_in("press", "item/" + study::to_text(row.path));
    wanted_.reset();
  } else if (row.kind == FormRow::Kind::add && *wanted_ == row.path) {
    pass.ui.focus.write_in("press", "add/" + study::to_text(row.path));
    wanted_.reset();
  }
}

// Which row the hand is on.
void EditForm::note(const FormPass& pass, const FormRow& row, const Box& box) {
  const std::string path = study::to_text(row.path);
  const bool item = row.kind == FormRow::Kind::item;
  const bool add = row.kind == FormRow::Kind::add;
  const bool focused = item  ? pass.ui.focus.on("press", "item/" + path)
                       : add ? pass.ui.focus.on("press", "add/" + path)
                             : has_control(pass.ui, path);
  const ImVec2 mouse = ImGui::GetIO().MousePos;
  const bool hovered = ImGui::IsWindowHovered(ImGuiHoveredFlags_AllowWhenBlockedByActiveItem) &&
                       box.holds(mouse.x, mouse.y);
  if (focused) {
    focused_ = row.path;
    if (!add && !item) fill(box, pass.ui.look.palette.known);
  }
  if ((!hovered && !focused) || help_hovered_) return;
  help_ = help_of(pass, row.field);
  help_hovered_ = hovered;
}

void EditForm::draw_label(const FormPass& pass, const FormRow& row, const Box& box) {
  const Palette& palette = pass.ui.look.palette;
  const float half = pass.ui.layout.size(22);
  // The label of a parameter is its key, and the table itself has none.
  const bool one_line = row.field.words.empty() || row.field.key.empty();
  draw_line(pass.ui.look.fonts.text, {box.x, box.y, box.width, one_line ? 2 * half : half},
            palette.text, label_of(pass, row.field));
  if (one_line) return;
  draw_line(pass.ui.look.fonts.text, {box.x, box.y + half, box.width, half}, palette.quiet,
            study::last_key(row.path));
}

void EditForm::draw_field(const FormPass& pass, const FormRow& row, const Box& box) {
  const float edge = pass.ui.layout.size(6);
  const float label = label_share * box.width;
  const float high = controls_.height(pass, row);
  draw_label(pass, row, {box.x + edge, box.y + edge - pass.ui.layout.size(4), label - 3 * edge, 0});
  const Box control{box.x + label, box.y + edge, box.width - label - edge, high};
  controls_.draw(pass, row, control);
  const float under = std::max(high, pass.ui.layout.size(44)) + edge;
  draw_problems(pass, row, {box.x + edge, box.y + under, box.width - 2 * edge, 0});
}

void EditForm::draw_list(const FormPass& pass, const FormRow& row, const Box& box) {
  const float edge = pass.ui.layout.size(6);
  const Box line{box.x + edge, box.y + edge, box.width - 2 * edge, pass.ui.layout.size(28)};
  draw_line(pass.ui.look.fonts.bold, line, pass.ui.look.palette.text, label_of(pass, row.field));
  draw_line(pass.ui.look.fonts.text, line, pass.ui.look.palette.quiet, row.field.key, Align::right);
  draw_problems(pass, row, {line.x, line.bottom(), line.width, 0});
}

void EditForm::draw_item(const FormPass& pass, const FormRow& row, const Box& box) {
  const Palette& palette = pass.ui.look.palette;
  const std::string path = study::to_text(row.path);
  const float high = pass.ui.layout.size(40);
  const Box line{box.x, box.y, box.width, high};
  fill(line, palette.on_colour);
  frame(line, palette.line, pass.ui.layout.size(1));
  const float buttons = pass.ui.layout.size(3 * 36);
  const Box title{line.x, line.y, line.width - buttons, high};
  const bool pressed = small_button(pass.ui, "press", "item/" + path, title, "");
  const float side = pass.ui.layout.size(14);
  draw_arrow({title.x + pass.ui.layout.size(10), title.middle_y() - 0.5f * side, side, side},
             row.open ? Arrow::unfolded : Arrow::folded, palette.quiet, pass.ui.layout.size(2));
  const float inset = pass.ui.layout.size(34);
  const float said = text_width(pass.ui.look.fonts.text, summary_of(pass, row));
  draw_line(pass.ui.look.fonts.bold,
            {title.x + inset, title.y, title.width - inset - said - pass.ui.layout.size(8), high},
            palette.text, row.title.empty() ? pass.words("edit.unnamed") : row.title);
  const std::string summary = summary_of(pass, row);
  draw_text(pass.ui.look.fonts.text, title, palette.quiet, summary, Align::right);
  draw_item_buttons(pass, row, {title.right(), line.y, buttons, high});
  const float edge = pass.ui.layout.size(6);
  draw_problems(pass, row, {box.x + edge, line.bottom(), box.width - 2 * edge, 0});
  if (!pressed) return;
  if (row.open) {
    open_.erase(path);
  } else {
    open_.insert(path);
  }
}

void EditForm::draw_item_buttons(const FormPass& pass, const FormRow& row, const Box& box) {
  const std::string path = study::to_text(row.path);
  const TomlPath list = study::parent_of(row.path);
  const float wide = box.width / 3;
  const auto cell = [&](int i) {
    return Box{box.x + static_cast<float>(i) * wide, box.y, wide, box.height};
  };
  const auto move = [&](std::size_t to) {
    if (!pass.scene.draft.change(study::move_value(list, row.index, to))) return;
    move_open(list, row.index, to);
    pass.ui.focus.go_on(
        "press", (to < row.index ? "up/" : "down/") + study::to_text(study::joined(list, to)));
  };
  if (arrow_button(pass.ui, "press", "up/" + path, cell(0), Arrow::up, row.index > 0)) {
    return move(row.index - 1);
  }
  const bool last = row.index + 1 == row.count;
  if (arrow_button(pass.ui, "press", "down/" + path, cell(1), Arrow::down, !last)) {
    return move(row.index + 1);
  }
  if (!icon_button(pass.ui, "press", "remove/" + path, cell(2), Icon::close)) return;
  if (pass.scene.draft.change(study::remove_value(row.path))) {
    fold_removed(list, row.index, row.count);
  }
}

// Those behind it move up.
void EditForm::fold_removed(const TomlPath& list, std::size_t index, std::size_t count) {
  for (std::size_t i = index; i + 1 < count; ++i) move_open(list, i, i + 1);
  std::erase_if(open_, [&](const std::string& one) {
    return study::begins_with(study::toml_path(one), study::joined(list, count - 1));
  });
  controls_.forget();
}

// What is unfolded in an item goes along with it; neighbours change places.
void EditForm::move_open(const TomlPath& list, std::size_t from, std::size_t to) {
  std::set<std::string> moved;
  for (const std::string& one : open_) {
    TomlPath path = study::toml_path(one);
    if (study::begins_with(path, study::joined(list, from))) {
      path[list.size()] = to;
    } else if (study::begins_with(path, study::joined(list, to))) {
      path[list.size()] = from;
    }
    moved.insert(study::to_text(path));
  }
  open_ = std::move(moved);
  controls_.forget();
}

void EditForm::draw_add(const FormPass& pass, const FormRow& row, const Box& box) {
  const std::string path = study::to_text(row.path);
  const std::string& label = pass.words("edit.add." + row.field.choices);
  const float wide = text_width(pass.ui.look.fonts.text, label) + pass.ui.layout.size(40);
  const Box place{box.x, box.y + pass.ui.layout.size(6), std::min(wide, box.width),
                  pass.ui.layout.size(36)};
  if (!button(pass.ui, "add/" + path, place, label, ButtonKind::outlined)) return;
  const study::TomlValue* list = study::value_at(pass.root(), row.path);
  const std::vector<study::TomlValue> items =
      list != nullptr ? list->elements : std::vector<study::TomlValue>{};
  const std::string& name = row.field.choices;
  const char* source = name == "interface"       ? "@types"
                       : name == "questionnaire" ? "@instruments"
                                                 : "@walks";
  const auto item = new_item(name, items, pass.scene.options.of(source));
  if (!pass.scene.draft.change(study::insert_value(row.path, items.size(), item))) return;
  open_.insert(study::to_text(study::joined(row.path, items.size())));
}

std::vector<const PlacedProblem*> EditForm::problems_of(const FormPass& pass,
                                                        const FormRow& row) const {
  std::vector<const PlacedProblem*> found;
  const bool whole =
      row.kind == FormRow::Kind::field || (row.kind == FormRow::Kind::item && !row.open);
  if (row.kind == FormRow::Kind::add) return found;
  for (const PlacedProblem& one : pass.scene.problems) {
    if (one.line == 0) continue;
    if (one.path == row.path || (whole && study::begins_with(one.path, row.path))) {
      found.push_back(&one);
    }
  }
  // The first row of a target has no key of its own.
  if (row.kind == FormRow::Kind::field && row.field.key.empty()) found.clear();
  return found;
}

float EditForm::problems_height(const FormPass& pass, const FormRow& row, float width) const {
  const float in = static_cast<float>(row.depth) * pass.ui.layout.size(indent);
  const float room = width - in - pass.ui.layout.size(12);
  float high = 0;
  if (row.kind == FormRow::Kind::field && controls_.is_refused(row.path)) {
    high += paragraphs_height(pass.ui.look.fonts.text, room, refusal_of(row.field, pass.words));
  }
  for (const PlacedProblem* one : problems_of(pass, row)) {
    high += paragraphs_height(pass.ui.look.fonts.text, room, one->problem.message);
  }
  return high > 0 ? high + pass.ui.layout.size(8) : 0;
}

// What the field takes, and that what stands in it is not in the file.
std::string EditForm::refusal_of(const EditField& field, const study::Texts& words) {
  const std::vector<std::pair<std::string, std::string>> ends = {
      {"least", fmt::format("{}", field.least)}, {"most", fmt::format("{}", field.most)}};
  switch (field.kind) {
    case FieldKind::whole:
      return words.with("edit.wants_whole", ends);
    case FieldKind::number:
      return words.with("edit.wants_number", ends);
    case FieldKind::auto_number:
      return words.with("edit.wants_auto", ends);
    case FieldKind::shares:
      return words("edit.wants_shares");
    default:
      return words("edit.no_value");
  }
}

float EditForm::draw_problems(const FormPass& pass, const FormRow& row, const Box& box) const {
  const Palette& palette = pass.ui.look.palette;
  ImFont* const font = pass.ui.look.fonts.text;
  float y = box.y;
  if (row.kind == FormRow::Kind::field && controls_.is_refused(row.path)) {
    y += draw_paragraphs(font, box.x, y, box.width, palette.alarm,
                         refusal_of(row.field, pass.words));
  }
  for (const PlacedProblem* one : problems_of(pass, row)) {
    const Rgb& colour =
        one->problem.severity == Severity::error ? palette.alarm : palette.steps.front();
    const float high = draw_paragraphs(font, box.x, y, box.width, colour, one->problem.message);
    place(pass.ui, "problem", study::to_text(row.path), {box.x, y, box.width, high}, false);
    y += high;
  }
  return y - box.y;
}

void EditForm::draw_help(const FormPass& pass, const Box& box) const {
  const Palette& palette = pass.ui.look.palette;
  fill({box.x, box.y, box.width, pass.ui.layout.size(1)}, palette.line);
  const std::string& text = help_.empty() ? pass.words("edit.help") : help_;
  draw_paragraphs(pass.ui.look.fonts.text, box.x + pass.ui.layout.size(4),
                  box.y + pass.ui.layout.size(8), box.width - pass.ui.layout.size(8),
                  help_.empty() ? palette.quiet : palette.text, text);
  place(pass.ui, "help", help_, box, false);
}

}  // namespace promenade::app
