// Names of files that fit a pattern: "*" is anything, "?" one character, {style} names the
// style; none of them reaches over a "/".
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace promenade::study {

// Does a path (its parts divided by "/") fit the pattern? Then its style: what {style}
// stands for, or the name of the file without its ending if the pattern has no {style}.
std::optional<std::string> style_of(const std::string& path, const std::string& pattern);

// What is wrong with a pattern; empty: nothing.
std::string trouble_with_pattern(const std::string& pattern);

struct FoundFile {
  std::string path;  // below the folder, with "/"
  std::string style;
};

// The files below a folder that fit, sorted by path; as deep as the pattern goes.
std::vector<FoundFile> find_files(const std::filesystem::path& folder, const std::string& pattern);

}  // namespace promenade::study
