// A capture of any kind that the program reads, by the ending of its name.
#pragma once

#include <filesystem>

#include "motion/clip.h"

namespace promenade::motion {

// Throws InputError. The place of its problems is `path` as given.
Clip load_clip(const std::filesystem::path& path);

}  // namespace promenade::motion
