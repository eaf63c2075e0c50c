// Until the motion core brings these.
#include "motion/builtin.h"
#include "motion/set_file.h"

namespace promenade::motion {

std::optional<MotionSet> builtin_set(std::string_view) { return std::nullopt; }

std::string to_bytes(const MotionSet& set) {
  std::string bytes = set.name;
  for (const Cycle& cycle : set.cycles) {
    bytes += cycle.name;
    bytes.append(reinterpret_cast<const char*>(cycle.rotations.data()),
                 static_cast<std::size_t>(cycle.rotations.size()) * sizeof(double));
  }
  return bytes;
}

}  // namespace promenade::motion
