// Any text as a path: refused with places, or one that can be walked along and made smooth.
#include <cstdint>
#include <cstdlib>

#include "motion/graph/ground_path.h"
#include "motion/problem.h"
#include "study/path_csv.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace promenade;
  try {
    const std::string_view text(reinterpret_cast<const char*>(data), size);
    const study::PathTable table = study::parse_path(text, "fuzz.csv");
    const motion::GroundPath path(table.points, "fuzz.csv");
    if (!path.at(0.5 * path.length()).allFinite()) std::abort();
    if (path.length() < 1000 && !motion::smooth_path(table.points, 1).allFinite()) std::abort();
  } catch (const InputError&) {
    // Refused with a place and a reason: that is what should happen.
  }
  return 0;
}
