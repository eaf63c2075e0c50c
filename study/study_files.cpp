#include <filesystem>

#include "study/study_parts.h"

namespace promenade::study {

const std::string& StudyFiles::read(const std::string& path) {
  const auto known = contents_.find(path);
  if (known != contents_.end()) return known->second;
  return contents_.emplace(path, load_(path, folder_)).first->second;
}

std::string StudyFiles::full_path(const std::string& path) const {
  return (std::filesystem::path(folder_) / path).string();
}

std::vector<StudyPart> StudyFiles::parts() const {
  std::vector<StudyPart> parts;
  for (const auto& [path, content] : contents_) parts.push_back({path, content});
  return parts;
}

void add_file_problems(const TomlTable& table, std::string_view key, const std::string& file,
                       const InputError& error) {
  for (const Problem& problem : error.problems()) {
    if (problem.line > 0) {
      table.reader().add({problem});
    } else {
      table.error(key, "cannot use " + file + ": " + problem.message);
    }
  }
}

}  // namespace promenade::study
