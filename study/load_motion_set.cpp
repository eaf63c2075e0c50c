// Built-in sets and set files; recipes come with the captures.
#include <filesystem>

#include "motion/builtin.h"
#include "motion/files.h"
#include "motion/set_file.h"
#include "study/study.h"

namespace promenade::study {

motion::MotionSet load_motion_set(const std::string& name, const std::string& folder) {
  if (const auto builtin = motion::builtin_name(name)) {
    if (auto set = motion::builtin_set(*builtin)) return std::move(*set);
    throw InputError(name, "there is no such built-in motion set, only builtin:A, :B and :N");
  }
  const std::string file = (std::filesystem::path(folder) / name).string();
  return motion::from_bytes(read_file(file), file);
}

}  // namespace promenade::study
