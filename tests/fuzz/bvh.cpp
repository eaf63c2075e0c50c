// Any bytes as a BVH file: read or refused, then written and read again.
#include "motion/bvh.h"

#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "motion/body_mapping.h"

namespace {

using namespace promenade;

void read(std::string_view text) {
  const motion::Clip clip = motion::read_bvh(text, "fuzz.bvh");
  if (clip.values.size() > 8 * static_cast<std::int64_t>(text.size())) std::abort();
  motion::forward_kinematics(clip, clip.frames() - 1);
  const motion::Clip again = motion::read_bvh(motion::bvh_text(clip), "again.bvh");
  if (again.frames() != clip.frames() || again.skeleton.size() != clip.skeleton.size()) {
    std::abort();
  }
  motion::find_figure(clip);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  try {
    read({reinterpret_cast<const char*>(data), size});
  } catch (const InputError&) {
    // Refused with a place and a reason: that is what should happen.
  }
  return 0;
}
