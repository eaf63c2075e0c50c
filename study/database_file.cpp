#include "study/database_file.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>

#include "motion/problem.h"

namespace promenade::study {
namespace {

[[noreturn]] void refuse_write(const std::string& file) {
  throw OutsideError("cannot write " + file + " (" + std::strerror(errno) +
                     "); name another place for the database");
}

bool sync(const std::string& path, int flags) {
  const int handle = ::open(path.c_str(), flags | O_RDONLY | O_CLOEXEC);
  if (handle < 0) return false;
  const bool done = ::fsync(handle) == 0;
  const int error = errno;
  ::close(handle);
  errno = error;
  return done;
}

}  // namespace

bool make_private_file(const std::string& file) {
  const int handle = ::open(file.c_str(), O_RDWR | O_CREAT | O_EXCL | O_CLOEXEC, 0600);
  if (handle >= 0) {
    ::close(handle);
    return true;
  }
  if (errno != EEXIST) refuse_write(file);
  require_writable(file);
  return false;
}

void require_writable(const std::string& file) {
  if (::access(file.c_str(), R_OK | W_OK) != 0) refuse_write(file);
}

void remove_database(const std::string& file) {
  std::error_code ignored;
  for (const char* ending : {"", "-wal", "-shm", "-journal"}) {
    std::filesystem::remove(file + ending, ignored);
  }
}

void rename_durably(const std::string& from, const std::string& to) {
  if (!sync(from, 0) || std::rename(from.c_str(), to.c_str()) != 0) refuse_write(to);
  const std::filesystem::path folder = std::filesystem::path(to).parent_path();
  sync(folder.empty() ? "." : folder.string(), O_DIRECTORY);  // not every disk can
}

}  // namespace promenade::study
