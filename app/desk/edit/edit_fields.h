// What the form of the Edit page can change, as a list: a line for each key of the study file. The
// form, its words (configs/desk/edit.*.toml) and its tests follow from it. docs/study-file.md says
// what each key means.
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "study/interface.h"
#include "study/toml_path.h"
#include "study/toml_reader.h"

namespace promenade::app {

enum class FieldKind {
  text,         // a line of text
  words,        // a line for each language of the study: "words", or { en = "words" }
  page,         // the same over several lines, `most` of them in sight
  spoken,       // the same, with the languages as keys of the table itself
  number,       // from `least` to `most`
  whole,        // a whole one
  auto_number,  // a number, or "auto"
  flag,         // true or false
  choice,       // one of `choices`
  pick,         // one of what the study has: `choices` names the source, "@walks"
  some,         // several of these
  nesting,      // the three loops of a session
  shares,       // { sad = 0.5, old = 0.5 }
  source,       // where a target comes from: which keys its table has
  list          // a list of tables; `choices` names what they are
};

struct EditField {
  std::string key;  // from the root, or from the table of its item; empty: the table itself
  FieldKind kind = FieldKind::text;
  std::string standard = {};  // what holds when the key is left out; empty: nothing does; "@name":
                              // the name of the item
  std::string choices = {};   // "a|b"; "@walks"; of a list the name of its items
  double least = 0, most = 0;
  bool needed = false;
  std::string when = {};      // shown if "kind=match|guess", or "has random"; or when it is there
  std::string words = {};     // its texts are edit.WORDS.label and .help; empty: see `own_help`
  std::string own_help = {};  // of a parameter of an interface, whose label is its key
};

// A tab of the form.
struct EditSection {
  std::string name;  // edit.section.NAME
  std::vector<EditField> fields;
};
const std::vector<EditSection>& edit_sections();

// The fields of the tables of a list: "task", "target", ...
const std::vector<EditField>& edit_items(std::string_view name);
std::vector<std::string> edit_item_names();

// The parameters of an interface of this type; none when there is no such type.
std::vector<EditField> parameter_fields(const study::InterfaceRegistry& registry,
                                        std::string_view type);

// "a|b|c" as a list.
std::vector<std::string> split_choices(std::string_view choices);

// Is the field to be seen in this table? What is in the file always is.
bool is_shown(const EditField& field, const study::TomlValue& table);

// The section that a value of the file belongs to; the first one if none does.
std::size_t section_of(const study::TomlPath& path);

}  // namespace promenade::app
