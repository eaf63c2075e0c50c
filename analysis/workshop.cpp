#include "analysis/workshop.h"

#include <unistd.h>

#include <algorithm>
#include <vector>

#include "motion/problem.h"

namespace promenade::analysis {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void cannot_write(const fs::path& path, const std::error_code& error) {
  throw OutsideError("cannot write " + path.string() + ": " + error.message() +
                     "; choose another place or make room");
}

std::vector<fs::path> files_in(const fs::path& folder, const std::string& last) {
  std::vector<fs::path> files;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    if (entry.is_regular_file()) files.push_back(fs::relative(entry.path(), folder));
  }
  std::sort(files.begin(), files.end(), [&](const fs::path& a, const fs::path& b) {
    const bool a_last = a == last;
    const bool b_last = b == last;
    return a_last != b_last ? b_last : a < b;
  });
  return files;
}

}  // namespace

fs::path wanted_folder(const fs::path& given) {
  fs::path folder = fs::absolute(given).lexically_normal();
  if (folder.filename().empty()) folder = folder.parent_path();
  std::error_code error;
  if (fs::exists(folder, error) && !fs::is_directory(folder, error)) {
    throw InputError(given.string(), "is a file; --out names a folder");
  }
  return folder;
}

Workshop::Workshop(const fs::path& wanted) : wanted_(wanted), path_(wanted) {
  path_ += "." + std::to_string(::getpid()) + ".part";
  std::error_code error;
  fs::create_directories(path_, error);
  if (error) cannot_write(wanted, error);
}

Workshop::~Workshop() {
  std::error_code ignored;
  fs::remove_all(path_, ignored);
}

void Workshop::put_in_place(const std::string& last) const {
  std::error_code error;
  if (!fs::exists(wanted_, error)) {
    fs::rename(path_, wanted_, error);
    if (error) cannot_write(wanted_, error);
    return;
  }
  for (const fs::path& file : files_in(path_, last)) {
    fs::create_directories((wanted_ / file).parent_path(), error);
    if (!error) fs::rename(path_ / file, wanted_ / file, error);
    if (error) cannot_write(wanted_ / file, error);
  }
}

std::string Workshop::as_wanted(std::string message) const {
  const std::string name = path_.string();
  for (std::size_t at; (at = message.find(name)) != std::string::npos;) {
    message.replace(at, name.size(), wanted_.string());
  }
  return message;
}

}  // namespace promenade::analysis
