// The files of configs/, compiled in, so that the program runs without its
// source tree. A path on disk always wins over an embedded one.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace promenade::study {

struct EmbeddedFile {
  std::string_view path;  // relative to configs/, with '/': "languages/en.toml"
  std::string_view content;
};

// All of them, sorted by path.
std::span<const EmbeddedFile> embedded_files();

// The content of "languages/en.toml" and the like; nothing if there is none.
std::optional<std::string_view> embedded_file(std::string_view path);

// "en", "ja" of the folder "languages": the names of its files without ".toml", sorted.
std::vector<std::string> embedded_names(std::string_view folder);

}  // namespace promenade::study
