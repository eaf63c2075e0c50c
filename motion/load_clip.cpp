#include "motion/load_clip.h"

#include "motion/bvh.h"
#include "motion/files.h"
#include "motion/scanner.h"

namespace promenade::motion {

Clip load_clip(const std::filesystem::path& path) {
  const std::string bytes = read_file(path);
  if (same_word(path.extension().string(), ".bvh")) return read_bvh(bytes, path.string());
  throw InputError(path.string(), "is not a kind of capture that this program reads (.bvh)");
}

}  // namespace promenade::motion
