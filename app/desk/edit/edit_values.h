// From what people write in the form to changes of the study file, and back. Knows no window.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/desk/edit/edit_fields.h"
#include "study/toml_edit.h"

namespace promenade::app {

using Edits = std::vector<study::TomlEdit>;

// What a field of one line shows of the value at its path: "" when there is none.
std::string shown_text(const study::TomlValue& root, const study::TomlPath& path,
                       const EditField& field);

// The changes that make the value what was written; an empty text leaves the key out. Nothing:
// that is no value for this field.
std::optional<Edits> edits_of_text(const study::TomlValue& root, const study::TomlPath& path,
                                   const EditField& field, const std::string& text);

// Texts by language. `spoken`: the languages are keys of the table at the path.
std::string shown_words(const study::TomlValue& root, const study::TomlPath& path,
                        const std::string& language);
Edits edits_of_words(const study::TomlValue& root, const study::TomlPath& path, bool spoken,
                     const std::string& language, const std::string& text);

// A list of texts that names some of `all`; left out, it stands for `standard`.
std::vector<std::string> shown_some(const study::TomlValue& root, const study::TomlPath& path,
                                    const std::vector<std::string>& standard);
Edits edits_of_some(const study::TomlValue& root, const study::TomlPath& path,
                    const std::vector<std::string>& standard, const std::string& one);

// The six orders of the three loops, "interface, task, target".
std::vector<std::string> nestings();

// Where a target comes from: "example", "weights", ... Another one makes it a new table.
const std::vector<std::string>& target_sources();
std::string shown_source(const study::TomlValue& root, const study::TomlPath& path);
study::TomlValue new_target(const std::string& source, const std::string& walk,
                            const std::string& stimulus);

// What a list of such items shows of one: "match", "sad", "adjectives".
std::string title_of(const study::TomlValue& item);
// A new item of a list that already holds `items`.
study::TomlValue new_item(std::string_view name, const std::vector<study::TomlValue>& items,
                          const std::vector<std::string>& choices);

}  // namespace promenade::app
