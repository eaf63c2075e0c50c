#include "study/file_stamp.h"

#include <sys/stat.h>

namespace promenade::study {

FileStamp file_stamp(const std::filesystem::path& path) {
  struct stat state {};
  if (::stat(path.c_str(), &state) != 0) return {};
  return {state.st_ino, state.st_size,
          std::int64_t{state.st_mtim.tv_sec} * 1'000'000'000 + state.st_mtim.tv_nsec};
}

DatabaseStamp database_stamp(const std::filesystem::path& path) {
  return {file_stamp(path), file_stamp(path.string() + "-wal")};
}

}  // namespace promenade::study
