// A capture of any kind that the program reads, by the ending of its name: .bvh, or
// .amc with its .asf.
#pragma once

#include <filesystem>

#include "motion/clip.h"

namespace promenade::motion {

struct LoadOptions {
  std::filesystem::path skeleton;  // the .asf of an .amc; looked for beside it if empty
  std::optional<double> rate;      // frames a second of an .amc; else as the file says
};

// Throws InputError. The place of its problems is `path` as given. Kinds that other
// programs convert are refused with the command that does it.
Clip load_clip(const std::filesystem::path& path, const LoadOptions& options = {});

// The skeleton of X_Y.amc: X.asf beside it, else the only .asf beside it. Throws
// InputError.
std::filesystem::path find_asf(const std::filesystem::path& amc);

}  // namespace promenade::motion
