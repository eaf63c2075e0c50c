#include "study/toml_path.h"

#include <algorithm>

#include "study/toml_text.h"

namespace promenade::study {
namespace {

// A key in double quotes from `at`, which is left behind them.
std::string quoted_key(std::string_view text, std::size_t& at) {
  std::string key;
  for (++at; at < text.size() && text[at] != '"'; ++at) {
    if (text[at] == '\\' && at + 1 < text.size()) ++at;
    key += text[at];
  }
  ++at;
  return key;
}

std::size_t place_in_list(std::string_view text, std::size_t& at) {
  std::size_t place = 0;
  for (++at; at < text.size() && text[at] != ']'; ++at) {
    place = 10 * place + static_cast<std::size_t>(text[at] - '0');
  }
  ++at;
  return place;
}

}  // namespace

bool is_bare_key(std::string_view key) {
  return !key.empty() && std::all_of(key.begin(), key.end(), [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' ||
           c == '-';
  });
}

std::string to_text(const TomlPath& path) {
  std::string text;
  for (const TomlStep& step : path) {
    if (const auto* place = std::get_if<std::size_t>(&step)) {
      text += "[" + std::to_string(*place) + "]";
    } else {
      if (!text.empty()) text += '.';
      text += written_key(std::get<std::string>(step));
    }
  }
  return text;
}

TomlPath toml_path(std::string_view text) {
  TomlPath path;
  for (std::size_t at = 0; at < text.size();) {
    if (text[at] == '.') {
      ++at;
    } else if (text[at] == '[') {
      path.emplace_back(place_in_list(text, at));
    } else if (text[at] == '"') {
      path.emplace_back(quoted_key(text, at));
    } else {
      const std::size_t end = std::min(text.find_first_of(".[", at), text.size());
      path.emplace_back(std::string(text.substr(at, end - at)));
      at = end;
    }
  }
  return path;
}

bool begins_with(const TomlPath& path, const TomlPath& beginning) {
  return path.size() >= beginning.size() &&
         std::equal(beginning.begin(), beginning.end(), path.begin());
}

TomlPath joined(TomlPath path, const TomlPath& rest) {
  path.insert(path.end(), rest.begin(), rest.end());
  return path;
}

TomlPath joined(TomlPath path, TomlStep step) {
  path.push_back(std::move(step));
  return path;
}

TomlPath parent_of(TomlPath path) {
  path.pop_back();
  return path;
}

std::string last_key(const TomlPath& path) {
  const std::string* key = path.empty() ? nullptr : std::get_if<std::string>(&path.back());
  return key != nullptr ? *key : "";
}

}  // namespace promenade::study
