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

}  // namespace promenade::study
