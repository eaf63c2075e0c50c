// Tells whether a file was written since it was looked at: another stamp, another content. (Within
// one tick of the disk's clock a second change of the same size looks like none.)
#pragma once

#include <cstdint>
#include <filesystem>

namespace promenade::study {

struct FileStamp {
  std::uint64_t file = 0;  // which one it is; 0: there is none
  std::int64_t size = -1;  // bytes
  std::int64_t ns = 0;     // when it was written
  auto operator<=>(const FileStamp&) const = default;
};

FileStamp file_stamp(const std::filesystem::path& path);

// Of a database and its journal (-wal), into which what is new goes first.
struct DatabaseStamp {
  FileStamp file, journal;
  auto operator<=>(const DatabaseStamp&) const = default;
};

DatabaseStamp database_stamp(const std::filesystem::path& path);

}  // namespace promenade::study
