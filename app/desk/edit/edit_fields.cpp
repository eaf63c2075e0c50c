#include "app/desk/edit/edit_fields.h"

#include <algorithm>

#include "study/toml_edit.h"

namespace promenade::app {
namespace {

using Kind = FieldKind;
using Fields = std::vector<EditField>;

constexpr double many = 100'000;

// A field says its texts by its key, below the name of its list.
Fields named(const std::string& prefix, Fields fields) {
  for (EditField& field : fields) {
    const std::string key = !field.key.empty()           ? field.key
                            : field.kind == Kind::spoken ? "words"
                                                         : "source";
    field.words = prefix.empty() ? key : prefix + "." + key;
  }
  return fields;
}

std::vector<EditSection> make_sections() {
  std::vector<EditSection> sections = {
      {"study",
       {{"study.name", Kind::text, "", "", 0, 0, true},
        {"study.version", Kind::text, "1"},
        {"study.participants", Kind::whole, "", "", 1, many},
        {"study.most_minutes", Kind::number, "60", "", 1, 1440},
        {"study.seed", Kind::whole, "1", "", 0, 9e15},
        {"study.published", Kind::pick, "", "@published"},
        {"study.prereg", Kind::text}}},
      {"texts",
       {{"study.languages", Kind::some, "en", "@languages"},
        {"study.title", Kind::words},
        {"study.consent", Kind::page}}},
      {"set",
       {{"study.set", Kind::pick, "builtin:A", "@sets"},
        {"study.ratings", Kind::text},
        {"stimulus", Kind::list, "", "stimulus"}}},
      {"interfaces", {{"interface", Kind::list, "", "interface"}}},
      {"tasks", {{"task", Kind::list, "", "task"}}},
      {"order",
       {{"study.order", Kind::choice, "williams", "williams|latin|random|fixed"},
        {"study.task_order", Kind::choice, "fixed", "fixed|random"},
        {"study.target_order", Kind::choice, "random", "fixed|random"},
        {"study.nesting", Kind::nesting, "interface, task, target"},
        {"practice.until", Kind::choice, "done", "done|criterion|released"},
        {"practice.successes", Kind::whole, "1", "", 1, 100},
        {"practice.most_rounds", Kind::whole, "3", "", 1, 100}}},
      {"questions",
       {{"questionnaire", Kind::list, "", "questionnaire"}, {"rating", Kind::list, "", "rating"}}},
      {"breaks",
       {{"breaks.after", Kind::choice, "none", "none|block"},
        {"breaks.every", Kind::whole, "", "", 1, 1000},
        {"breaks.least_s", Kind::number, "0", "", 0, 3600},
        {"safety.resume", Kind::choice, "continue", "continue|trial|block"},
        {"safety.leave", Kind::flag, "false"},
        {"safety.withdraw", Kind::choice, "everything", "everything|link"},
        {"safety.copy_to", Kind::text},
        {"safety.keep", Kind::text}}},
      {"display",
       {{"display.colours", Kind::choice, "standard", "standard|paper"},
        {"display.walk", Kind::choice, "ground", "ground|spot"},
        {"display.examples", Kind::choice, "none", "none|panel|screen"},
        {"display.screen", Kind::whole, "1", "", 1, 16},
        {"display.scale", Kind::number, "1", "", 0.5, 1}}}};
  for (EditSection& section : sections) section.fields = named("", std::move(section.fields));
  return sections;
}

Fields interface_fields() {
  return {{"name", Kind::text, "", "", 0, 0, true}, {"type", Kind::pick, "@name", "@types"}};
}

Fields task_fields() {
  return {{"name", Kind::text, "", "", 0, 0, true},
          {"kind", Kind::choice, "", "match|guess|find|rate", 0, 0, true},
          {"targets", Kind::list, "", "target", 0, 0, false, "kind=match|guess|rate"},
          {"qualities", Kind::list, "", "quality", 0, 0, false, "kind=find"},
          {"practice", Kind::list, "", "target", 0, 0, false, "kind=match|guess|rate"},
          {"practice", Kind::list, "", "quality", 0, 0, false, "kind=find"},
          {"instrument", Kind::pick, "", "@instruments", 0, 0, true, "kind=rate"},
          {"each", Kind::whole, "", "", 1, many, false, "kind=rate"},
          {"repeats", Kind::whole, "0", "", 0, many, false, "kind=rate"},
          {"interfaces", Kind::some, "", "@interfaces", 0, 0, false, "kind=match|guess|find"},
          {"limit_s", Kind::number, "", "", 1, 86'400},
          {"threshold", Kind::auto_number, "", "", 0.0001, 10, false, "kind=match|guess"},
          {"dwell_ms", Kind::number, "500", "", 0, 60'000, false, "kind=match|guess"},
          {"done", Kind::flag, "true", "", 0, 0, false, "kind=match|find"},
          {"start", Kind::pick, "average", "@starts", 0, 0, false, "kind=match"},
          {"deal", Kind::choice, "same", "same|rotated", 0, 0, false, "kind=match|guess|find"},
          {"distance", Kind::choice, "time", "time|phase", 0, 0, false, "kind=match|guess"},
          {"reference", Kind::pick, "", "@walks"},
          {"blind", Kind::flag, "false", "", 0, 0, false, "kind=match|find"},
          {"playback", Kind::flag, "false"}};
}

Fields target_fields() {
  return {{"", Kind::source},
          {"example", Kind::pick, "", "@walks", 0, 0, true, "has example"},
          {"weights", Kind::shares, "", "", 0, 0, true, "has weights"},
          {"random", Kind::choice, "", "adjectives|features|weights|pca|examples", 0, 0, true,
           "has random"},
          {"file", Kind::text, "", "", 0, 0, true, "has file"},
          {"stimulus", Kind::pick, "", "@stimuli", 0, 0, true, "has stimulus"},
          {"name", Kind::text, "", "", 0, 0, false, "has weights|example|random"},
          {"count", Kind::whole, "", "", 1, 100, true, "has random"},
          {"draw", Kind::whole, "", "", 1, many, false, "has random"},
          {"per", Kind::choice, "study", "study|participant", 0, 0, false, "has random"},
          {"kept_in", Kind::text, "", "", 0, 0, false, "has random"}};
}

Fields quality_fields() {
  return {{"name", Kind::text, "", "", 0, 0, true}, {"", Kind::spoken}, {"pair", Kind::text}};
}

Fields questionnaire_fields() {
  return {{"instrument", Kind::pick, "", "@instruments", 0, 0, true},
          {"when", Kind::choice, "", "start|trial|task|block|end", 0, 0, true},
          {"tasks", Kind::some, "", "@tasks", 0, 0, false, "when=trial|task"}};
}

Fields rating_fields() {
  return {{"item", Kind::text, "", "", 0, 0, true},
          {"question", Kind::page, "", "", 0, 2, true},
          {"low", Kind::words},
          {"high", Kind::words},
          {"points", Kind::whole, "7", "", 2, 11}};
}

Fields stimulus_fields() {
  return {{"name", Kind::text, "", "", 0, 0, true},
          {"graph", Kind::text, "", "", 0, 0, true},
          {"parts", Kind::list, "", "part"},
          {"seed", Kind::whole, "1", "", 0, 9e15}};
}

Fields part_fields() {
  return {{"label", Kind::text, "", "", 0, 0, true},
          {"seconds", Kind::number, "", "", 0.1, 600, true}};
}

std::map<std::string, Fields, std::less<>> make_items() {
  std::map<std::string, Fields, std::less<>> items = {{"interface", interface_fields()},
                                                      {"task", task_fields()},
                                                      {"target", target_fields()},
                                                      {"quality", quality_fields()},
                                                      {"questionnaire", questionnaire_fields()},
                                                      {"rating", rating_fields()},
                                                      {"stimulus", stimulus_fields()},
                                                      {"part", part_fields()}};
  for (auto& [name, fields] : items) fields = named(name, std::move(fields));
  return items;
}

const std::map<std::string, Fields, std::less<>>& all_items() {
  static const auto items = make_items();
  return items;
}

bool holds(const std::vector<std::string>& words, const std::string& word) {
  return std::find(words.begin(), words.end(), word) != words.end();
}

EditField field_of(const study::ParameterSpec& spec) {
  EditField field;
  field.key = spec.name;
  field.standard = study::to_text(spec.standard);
  field.own_help = spec.sentence;
  if (std::holds_alternative<bool>(spec.standard)) {
    field.kind = Kind::flag;
  } else if (std::holds_alternative<double>(spec.standard)) {
    field.kind = spec.whole ? Kind::whole : Kind::number;
    field.least = spec.least;
    field.most = spec.most;
  } else if (!spec.choices.empty()) {
    field.kind = Kind::choice;
    for (const std::string& choice : spec.choices) {
      field.choices += (field.choices.empty() ? "" : "|") + choice;
    }
  }
  return field;
}

}  // namespace

const std::vector<EditSection>& edit_sections() {
  static const std::vector<EditSection> sections = make_sections();
  return sections;
}

const std::vector<EditField>& edit_items(std::string_view name) {
  return all_items().find(name)->second;
}

std::vector<std::string> edit_item_names() {
  std::vector<std::string> names;
  for (const auto& [name, fields] : all_items()) names.push_back(name);
  return names;
}

std::vector<EditField> parameter_fields(const study::InterfaceRegistry& registry,
                                        std::string_view type) {
  std::vector<EditField> fields;
  const study::InterfaceType* found = registry.find(type);
  if (found == nullptr) return fields;
  for (const study::ParameterSpec& spec : found->parameters) fields.push_back(field_of(spec));
  return fields;
}

std::vector<std::string> split_choices(std::string_view choices) {
  std::vector<std::string> words;
  while (!choices.empty()) {
    const std::size_t end = std::min(choices.find('|'), choices.size());
    words.emplace_back(choices.substr(0, end));
    choices.remove_prefix(std::min(end + 1, choices.size()));
  }
  return words;
}

bool is_shown(const EditField& field, const study::TomlValue& table) {
  constexpr std::string_view has = "has ";
  const std::string_view when = field.when;
  const bool two_meanings = field.key == "practice";  // of targets, or of qualities
  if (when.empty()) return true;
  if (!two_meanings && study::find_key(table, field.key) != nullptr) return true;
  if (when.starts_with(has)) {
    const std::vector<std::string> keys = split_choices(when.substr(has.size()));
    return std::any_of(keys.begin(), keys.end(), [&](const std::string& key) {
      return study::find_key(table, key) != nullptr;
    });
  }
  const std::size_t equals = when.find('=');
  const study::TomlValue* value = study::find_key(table, when.substr(0, equals));
  return value != nullptr && holds(split_choices(when.substr(equals + 1)), value->text);
}

std::size_t section_of(const study::TomlPath& path) {
  const std::vector<EditSection>& sections = edit_sections();
  const auto find = [&](const auto& belongs) {
    for (std::size_t i = 0; i < sections.size(); ++i) {
      for (const EditField& field : sections[i].fields) {
        if (belongs(study::toml_path(field.key))) return i;
      }
    }
    return sections.size();
  };
  const std::size_t of_value =
      find([&](const study::TomlPath& key) { return study::begins_with(path, key); });
  if (of_value < sections.size()) return of_value;
  // A table as a whole, with keys in it that are fields.
  const std::size_t of_table = find(
      [&](const study::TomlPath& key) { return !path.empty() && study::begins_with(key, path); });
  return of_table < sections.size() ? of_table : 0;
}

}  // namespace promenade::app
