// Whole files in and out. A written file appears complete or not at all.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace promenade {

// Throws InputError for a folder, and for a pipe or device, which might never end. A
// missing file passes.
void check_is_file(const std::filesystem::path& path);

// The bytes of a file. Throws InputError when it is missing, no file or unreadable.
std::string read_file(const std::filesystem::path& path);

// Writes beside the target and renames: a killed program leaves the old file or
// the new one. Makes missing folders, and takes them away again if it fails. Throws
// OutsideError.
void write_file(const std::filesystem::path& path, std::string_view bytes);

struct NamedBytes {
  std::string name, bytes;
};

// Several files of one folder, all of them or none that was not there before.
void write_files(const std::filesystem::path& folder, const std::vector<NamedBytes>& files);

}  // namespace promenade
