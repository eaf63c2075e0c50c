// Which value of a TOML file is meant: keys of tables and places in lists, from the root. Written
// out as in `task[0].targets[1].name`, where a key that is no bare one stands in quotes.
#pragma once

#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace promenade::study {

using TomlStep = std::variant<std::string, std::size_t>;  // a key, or a place in a list, from 0
using TomlPath = std::vector<TomlStep>;

// May the key stand in a file without quotes?
bool is_bare_key(std::string_view key);

std::string to_text(const TomlPath& path);
// The way back, of what to_text() wrote.
TomlPath toml_path(std::string_view text);

// Does `path` lead into what `beginning` names, or to it?
bool begins_with(const TomlPath& path, const TomlPath& beginning);

TomlPath joined(TomlPath path, const TomlPath& rest);
TomlPath joined(TomlPath path, TomlStep step);
TomlPath parent_of(TomlPath path);  // of a path that is not empty

// The key at the end; empty where a place in a list stands there.
std::string last_key(const TomlPath& path);

}  // namespace promenade::study
