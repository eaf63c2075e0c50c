#include "app/desk/edit/edit_controls.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "app/choice.h"

namespace promenade::app {
namespace {

constexpr float line_height = 36;
constexpr float tick_height = 32;
constexpr float gap = 6;

bool is_written(FieldKind kind) {
  return kind == FieldKind::text || kind == FieldKind::number || kind == FieldKind::whole ||
         kind == FieldKind::auto_number || kind == FieldKind::shares;
}

bool is_by_language(FieldKind kind) {
  return kind == FieldKind::words || kind == FieldKind::page || kind == FieldKind::spoken;
}

// Files of one's own can be named beside what there is.
bool takes_files(const EditField& field) {
  return field.choices == "@sets" || field.choices == "@instruments";
}

// What can be chosen, and what the file says although it cannot.
std::vector<std::string> options_of(const FormPass& pass, const FormRow& row) {
  std::vector<std::string> options;
  if (row.field.kind == FieldKind::nesting) {
    options = nestings();
  } else if (row.field.choices.starts_with("@")) {
    options = pass.scene.options.of(row.field.choices);
  } else {
    options = split_choices(row.field.choices);
  }
  return options;
}

void add_missing(const std::string& word, std::vector<std::string>& options) {
  if (!word.empty() && std::find(options.begin(), options.end(), word) == options.end()) {
    options.push_back(word);
  }
}

// "none", or "45 (standard)".
std::string left_out(const FormPass& pass, const FormRow& row) {
  std::string standard = row.field.standard;
  if (standard == "@name") {
    const study::TomlValue* item = study::value_at(pass.root(), study::parent_of(row.path));
    standard = item != nullptr ? title_of(*item) : "";
  }
  if (standard.empty()) return pass.words("edit.nothing");
  return pass.words.with("edit.left_out", {{"value", standard}});
}

// Of the box for one language.
float words_height(const EditField& field) {
  constexpr double lines = 4;
  if (field.kind != FieldKind::page) return line_height;
  return static_cast<float>(20 + 18 * (field.most > 0 ? field.most : lines));
}

std::vector<std::string> standard_of(const FormPass& pass, const FormRow& row) {
  if (row.field.standard.empty()) return options_of(pass, row);
  return {row.field.standard};
}

}  // namespace

std::vector<std::string> FormPass::languages() const {
  return app::shown_some(root(), study::toml_path("study.languages"), {"en"});
}

float EditControls::height(const FormPass& pass, const FormRow& row) const {
  const auto lines = [](std::size_t count, float high) {
    const auto n = static_cast<float>(count);
    return n * high + (n - 1) * gap;
  };
  float high = line_height;
  if (row.field.kind == FieldKind::some) {
    std::vector<std::string> options = options_of(pass, row);
    for (const auto& one : shown_some(pass.root(), row.path, {})) add_missing(one, options);
    const std::size_t rows = (options.size() + 1) / 2;
    high = std::max(line_height, static_cast<float>(rows) * tick_height);
  } else if (is_by_language(row.field.kind)) {
    high = lines(pass.languages().size(), words_height(row.field));
  } else if (takes_files(row.field)) {
    high = lines(2, line_height);
  }
  return pass.ui.layout.size(high);
}

void EditControls::draw(const FormPass& pass, const FormRow& row, const Box& box) {
  const FieldKind kind = row.field.kind;
  if (is_written(kind)) return draw_text(pass, row, box);
  if (is_by_language(kind)) return draw_words(pass, row, box);
  if (kind == FieldKind::flag) return draw_flag(pass, row, box);
  if (kind == FieldKind::some) return draw_some(pass, row, box);
  if (kind == FieldKind::source) return draw_source(pass, row, box);
  draw_choice(pass, row, box);
}

std::pair<std::string, std::string> EditControls::stop_of(const FormPass& pass,
                                                          const FormRow& row) {
  const std::string target = study::to_text(row.path);
  const FieldKind kind = row.field.kind;
  if (is_written(kind)) return {"type", target};
  if (is_by_language(kind)) return {"type", target + "/" + pass.languages().front()};
  if (kind == FieldKind::flag) return {"tick", target};
  if (kind != FieldKind::some) return {"open", target};
  const std::vector<std::string> options = options_of(pass, row);
  return {"tick", target + "/" + (options.empty() ? "" : options.front())};
}

void EditControls::leave() {
  for (auto& [target, field] : boxes_) field.hide();
}

bool EditControls::is_refused(const study::TomlPath& path) const {
  const auto found = boxes_.find(study::to_text(path));
  return found != boxes_.end() && found->second.refused();
}

bool EditControls::write(const FormPass& pass, const Box& box, const WrittenField::Look& look) {
  WrittenField& field = boxes_[look.target];
  const bool changed = field.draw(pass.ui, box, look, pass.scene.now_us);
  if (field.left()) pass.scene.draft.end_gesture();
  return changed;
}

template <typename Shown>
void EditControls::take(const FormPass& pass, const std::string& target,
                        const std::optional<Edits>& edits, const Shown& shown) {
  if (edits && pass.scene.draft.change(*edits, target)) {
    boxes_[target].accept(shown());
  } else {
    boxes_[target].refuse();
  }
}

void EditControls::change(const FormPass& pass, const std::optional<Edits>& edits) {
  if (edits && !edits->empty()) pass.scene.draft.change(*edits);
}

void EditControls::draw_text(const FormPass& pass, const FormRow& row, const Box& box) {
  const std::string target = study::to_text(row.path);
  const std::string hint = row.field.needed ? "" : left_out(pass, row);
  const auto shown = [&] { return shown_text(pass.root(), row.path, row.field); };
  if (!write(pass, box, {target, shown(), hint})) return;
  take(pass, target, edits_of_text(pass.root(), row.path, row.field, boxes_[target].words()),
       shown);
}

void EditControls::draw_words(const FormPass& pass, const FormRow& row, const Box& box) {
  const bool spoken = row.field.kind == FieldKind::spoken;
  const float high = pass.ui.layout.size(words_height(row.field));
  const float name = pass.ui.layout.size(28);
  const std::string hint = row.field.needed ? "" : left_out(pass, row);
  Box line{box.x + name, box.y, box.width - name, high};
  for (const std::string& language : pass.languages()) {
    const std::string target = study::to_text(row.path) + "/" + language;
    app::draw_text(pass.ui.look.fonts.text, {box.x, line.y, name, pass.ui.layout.size(line_height)},
                   pass.ui.look.palette.quiet, language);
    const auto shown = [&] { return app::shown_words(pass.root(), row.path, language); };
    if (write(pass, line, {target, shown(), hint, row.field.kind == FieldKind::page})) {
      take(pass, target,
           edits_of_words(pass.root(), row.path, spoken, language, boxes_[target].words()), shown);
    }
    line.y += high + pass.ui.layout.size(gap);
  }
}

void EditControls::draw_choice(const FormPass& pass, const FormRow& row, const Box& box) {
  const std::string target = study::to_text(row.path);
  const std::string now = shown_text(pass.root(), row.path, row.field);
  std::vector<std::string> options = options_of(pass, row);
  add_missing(now, options);
  const bool optional = !row.field.needed;
  const auto found = std::find(options.begin(), options.end(), now);
  auto chosen = static_cast<std::size_t>(found - options.begin()) + (optional ? 1 : 0);
  if (now.empty()) chosen = optional ? 0 : options.size();
  std::vector<std::string> labels = options;
  if (optional) labels.insert(labels.begin(), left_out(pass, row));
  const Box line{box.x, box.y, box.width, pass.ui.layout.size(line_height)};
  if (const auto picked = drop_down(pass.ui, target, line, labels, chosen)) {
    const std::string word =
        optional ? (*picked == 0 ? "" : options[*picked - 1]) : options[*picked];
    change(pass, edits_of_text(pass.root(), row.path, row.field, word));
  }
  if (!takes_files(row.field)) return;
  FormRow text = row;
  text.field.kind = FieldKind::text;
  draw_text(pass, text, {box.x, line.bottom() + pass.ui.layout.size(gap), box.width, line.height});
}

void EditControls::draw_flag(const FormPass& pass, const FormRow& row, const Box& box) {
  const std::string target = study::to_text(row.path);
  const std::string now = shown_text(pass.root(), row.path, row.field);
  const std::string value = now.empty() ? row.field.standard : now;
  const std::string label = now.empty() ? left_out(pass, row) : pass.words("edit." + value);
  if (!check_box(pass.ui, target, box, label, value == "true")) return;
  const std::string other = value == "true" ? "false" : "true";
  change(pass, edits_of_text(pass.root(), row.path, row.field, other));
}

void EditControls::draw_some(const FormPass& pass, const FormRow& row, const Box& box) {
  const std::vector<std::string> standard = standard_of(pass, row);
  const std::vector<std::string> now = shown_some(pass.root(), row.path, standard);
  std::vector<std::string> options = options_of(pass, row);
  for (const std::string& one : now) add_missing(one, options);
  const float high = pass.ui.layout.size(tick_height);
  const float wide = 0.5f * box.width;
  for (std::size_t i = 0; i < options.size(); ++i) {
    const std::size_t column = i % 2, line = i / 2;
    const Box one{box.x + static_cast<float>(column) * wide,
                  box.y + static_cast<float>(line) * high, wide, high};
    const bool on = std::find(now.begin(), now.end(), options[i]) != now.end();
    const std::string target = study::to_text(row.path) + "/" + options[i];
    if (check_box(pass.ui, target, one, options[i], on)) {
      change(pass, edits_of_some(pass.root(), row.path, standard, options[i]));
    }
  }
}

void EditControls::draw_source(const FormPass& pass, const FormRow& row, const Box& box) {
  const std::string target = study::to_text(row.path);
  const std::vector<std::string>& sources = target_sources();
  std::vector<std::string> labels;
  for (const std::string& source : sources) labels.push_back(pass.words("edit.source." + source));
  const auto found = std::find(sources.begin(), sources.end(), shown_source(pass.root(), row.path));
  const auto picked =
      drop_down(pass.ui, target, box, labels, static_cast<std::size_t>(found - sources.begin()));
  if (!picked) return;
  const auto first = [&](const char* source) {
    const std::vector<std::string>& names = pass.scene.options.of(source);
    return names.empty() ? std::string() : names.front();
  };
  const auto value = new_target(sources[*picked], first("@walks"), first("@stimuli"));
  change(pass, Edits{study::set_value(row.path, value)});
}

}  // namespace promenade::app
