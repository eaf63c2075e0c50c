#include "motion/files.h"

#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <memory>
#include <system_error>

#include "motion/problem.h"

namespace promenade {
namespace {

struct CloseFile {
  void operator()(std::FILE* file) const { std::fclose(file); }
};
using File = std::unique_ptr<std::FILE, CloseFile>;

[[noreturn]] void cannot_write(const std::filesystem::path& path, int error) {
  throw OutsideError("cannot write " + path.string() + ": " + std::strerror(error) +
                     "; choose another place or make room");
}

// A folder and those that it lies in, as far as they are missing; gone again with whoever
// made them unless they are to stay.
class MadeFolders {
 public:
  explicit MadeFolders(const std::filesystem::path& folder) {
    std::error_code error;
    for (auto up = folder; !up.empty() && !std::filesystem::exists(up, error);
         up = up.parent_path()) {
      made_.push_back(up);
    }
    if (!folder.empty()) std::filesystem::create_directories(folder, error);
    if (!error) return;
    remove();
    cannot_write(folder, error.value());
  }
  ~MadeFolders() { remove(); }
  MadeFolders(const MadeFolders&) = delete;
  MadeFolders& operator=(const MadeFolders&) = delete;

  void keep() { made_.clear(); }

 private:
  // Only what is empty goes.
  void remove() {
    std::error_code ignored;
    for (const std::filesystem::path& folder : made_) std::filesystem::remove(folder, ignored);
  }

  std::vector<std::filesystem::path> made_;  // the deepest first
};

}  // namespace

void check_is_file(const std::filesystem::path& path) {
  std::error_code ignored;
  const std::filesystem::file_status status = std::filesystem::status(path, ignored);
  if (std::filesystem::is_directory(status)) {
    throw InputError(path.string(), "is a folder; a file is wanted here");
  }
  if (std::filesystem::exists(status) && !std::filesystem::is_regular_file(status)) {
    throw InputError(path.string(), "is a pipe or device; a file is wanted here");
  }
}

std::string read_file(const std::filesystem::path& path) {
  check_is_file(path);
  File file(std::fopen(path.c_str(), "rb"));
  if (!file)
    throw InputError(path.string(), std::string("cannot be read: ") + std::strerror(errno));
  std::string bytes;
  // Growing by doubling would hold the file three times at the last step.
  std::error_code ignored;
  const std::uintmax_t size = std::filesystem::file_size(path, ignored);
  if (!ignored && size < bytes.max_size()) bytes.reserve(static_cast<std::size_t>(size) + 1);
  char block[1 << 16];
  while (const std::size_t count = std::fread(block, 1, sizeof block, file.get())) {
    bytes.append(block, count);
  }
  if (std::ferror(file.get())) throw InputError(path.string(), "cannot be read to its end");
  return bytes;
}

void write_file(const std::filesystem::path& path, std::string_view bytes) {
  MadeFolders folders(path.parent_path());
  std::filesystem::path beside = path;
  beside += "." + std::to_string(::getpid()) + ".part";
  File file(std::fopen(beside.c_str(), "wb"));
  if (!file) cannot_write(path, errno);
  const bool whole = std::fwrite(bytes.data(), 1, bytes.size(), file.get()) == bytes.size() &&
                     std::fflush(file.get()) == 0 && ::fsync(::fileno(file.get())) == 0;
  const int write_error = errno;
  file.reset();
  std::error_code error;
  if (whole) std::filesystem::rename(beside, path, error);
  if (whole && !error) return folders.keep();
  std::error_code ignored;
  std::filesystem::remove(beside, ignored);
  cannot_write(path, whole ? error.value() : write_error);
}

void write_files(const std::filesystem::path& folder, const std::vector<NamedBytes>& files) {
  MadeFolders folders(folder);
  std::vector<std::filesystem::path> made;
  try {
    for (const NamedBytes& file : files) {
      const std::filesystem::path path = folder / file.name;
      std::error_code ignored;
      const bool there = std::filesystem::exists(path, ignored);
      write_file(path, file.bytes);
      if (!there) made.push_back(path);
    }
  } catch (const OutsideError&) {
    std::error_code ignored;
    for (const std::filesystem::path& path : made) std::filesystem::remove(path, ignored);
    throw;
  }
  folders.keep();
}

}  // namespace promenade
