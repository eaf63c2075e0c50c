// Where the repository lies, for tests that read its files.
#pragma once

#include <filesystem>

namespace promenade {

std::filesystem::path source_dir();

}  // namespace promenade
