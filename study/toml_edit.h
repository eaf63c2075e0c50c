// One change of a TOML file, done in its text: everything else (remarks, order, blanks, line ends,
// keys that nobody knows) stays to the byte. The result is read again with parse_toml, and must say
// exactly what the old text said with that one change: what cannot be done so is refused.
#pragma once

#include <string>

#include "study/toml_path.h"
#include "study/toml_reader.h"
#include "study/toml_text.h"

namespace promenade::study {

struct TomlEdit {
  enum class Kind {
    set,     // the value at `path`; where there is none, the key is added, and its table if need be
    remove,  // the value at `path` with its key, its place in a list, or its [[block]]
    insert,  // `value` into the list at `path`, before its element `at`; at most at its end
    move     // the element `at` of the list at `path` to the place `to`
  };
  Kind kind = Kind::set;
  TomlPath path;
  TomlValue value;
  std::size_t at = 0, to = 0;
};

TomlEdit set_value(TomlPath path, TomlValue value);
TomlEdit remove_value(TomlPath path);
// Tables go into [[blocks]] where the list has them, or where there is no such list yet in the
// root of the file; else everything goes between [ and ].
TomlEdit insert_value(TomlPath list, std::size_t at, TomlValue value);
TomlEdit move_value(TomlPath list, std::size_t from, std::size_t to);

// The text after the change. Throws InputError with a sentence (about `file`) when the text is no
// TOML, when there is nothing at the path, or when the change cannot be done without another one.
std::string edited_toml(const std::string& file, const std::string& text, const TomlEdit& edit);

// The same change of values; false: there is nothing at its path.
bool apply_edit(TomlValue& root, const TomlEdit& edit);

// The value at a path; null: there is none.
const TomlValue* value_at(const TomlValue& root, const TomlPath& path);

}  // namespace promenade::study
