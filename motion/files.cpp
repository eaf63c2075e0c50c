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
  std::error_code error;
  if (path.has_parent_path()) std::filesystem::create_directories(path.parent_path(), error);
  if (error) cannot_write(path.parent_path(), error.value());
  std::filesystem::path beside = path;
  beside += "." + std::to_string(::getpid()) + ".part";
  File file(std::fopen(beside.c_str(), "wb"));
  if (!file) cannot_write(path, errno);
  const bool whole = std::fwrite(bytes.data(), 1, bytes.size(), file.get()) == bytes.size() &&
                     std::fflush(file.get()) == 0 && ::fsync(::fileno(file.get())) == 0;
  const int write_error = errno;
  file.reset();
  if (whole) std::filesystem::rename(beside, path, error);
  if (whole && !error) return;
  std::error_code ignored;
  std::filesystem::remove(beside, ignored);
  cannot_write(path, whole ? error.value() : write_error);
}

}  // namespace promenade
