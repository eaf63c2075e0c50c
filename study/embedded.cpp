#include "study/embedded.h"

#include <algorithm>

namespace promenade::study {

std::optional<std::string_view> embedded_file(std::string_view path) {
  for (const EmbeddedFile& file : embedded_files()) {
    if (file.path == path) return file.content;
  }
  return std::nullopt;
}

std::vector<std::string> embedded_names(std::string_view folder) {
  constexpr std::string_view ending = ".toml";
  const std::string beginning = std::string(folder) + "/";
  std::vector<std::string> names;
  for (const EmbeddedFile& file : embedded_files()) {
    if (file.path.substr(0, beginning.size()) != beginning) continue;
    if (file.path.substr(file.path.size() - ending.size()) != ending) continue;
    const std::size_t length = file.path.size() - beginning.size() - ending.size();
    names.emplace_back(file.path.substr(beginning.size(), length));
  }
  std::sort(names.begin(), names.end());  // "a" before "a-b", unlike "a.toml"
  return names;
}

}  // namespace promenade::study
