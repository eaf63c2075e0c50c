// Any bytes as an Acclaim motion: read against a small skeleton or refused, then written
// as BVH and read again.
#include "motion/amc.h"

#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "motion/body_mapping.h"
#include "motion/bvh.h"
#include "tests/motion/toy_asf.h"

namespace {

using namespace promenade;

void read(std::string_view text) {
  static const motion::AsfSkeleton skeleton = motion::read_asf(motion::toy_asf, "toy.asf");
  const motion::Clip clip = motion::read_amc(text, "fuzz.amc", skeleton);
  if (clip.values.size() > 8 * static_cast<std::int64_t>(text.size())) std::abort();
  motion::forward_kinematics(clip, clip.frames() - 1);
  motion::find_gaps(clip);
  const motion::Clip again = motion::read_bvh(motion::bvh_text(clip), "again.bvh");
  if (again.frames() != clip.frames() || again.skeleton.size() != clip.skeleton.size()) {
    std::abort();
  }
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
