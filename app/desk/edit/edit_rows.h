// The rows of one tab of the form, as they follow from the file and from what is unfolded.
#pragma once

#include <set>
#include <string>
#include <vector>

#include "app/desk/edit/edit_fields.h"
#include "study/toml_edit.h"

namespace promenade::app {

struct FormRow {
  enum class Kind {
    field,
    list,  // its heading
    item,  // one of the list; unfolded, its own rows follow
    add    // the button below
  };
  Kind kind = Kind::field;
  EditField field;
  study::TomlPath path;  // of the value, the list or the item
  int depth = 0;
  std::size_t index = 0, count = 0;  // of an item in its list; of a list its length
  bool open = false;
  std::string title = {};  // of an item
};

// `open`: paths of items, written out.
std::vector<FormRow> form_rows(const study::TomlValue& root,
                               const study::InterfaceRegistry& registry, const EditSection& section,
                               const std::set<std::string>& open);

// Unfolds what is needed for the row of this value to be there.
void unfold(const study::TomlPath& path, std::set<std::string>& open);

}  // namespace promenade::app
