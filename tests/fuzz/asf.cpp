// Any bytes as an Acclaim skeleton, and behind a byte 0 its motion: read or refused, then
// posed and looked at as a figure.
#include "motion/asf.h"

#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "motion/amc.h"
#include "motion/body_mapping.h"
#include "motion/bvh.h"

namespace {

using namespace promenade;

void read(std::string_view text) {
  const std::string_view skeleton_text = text.substr(0, text.find('\0'));
  const motion::AsfSkeleton skeleton = motion::read_asf(skeleton_text, "fuzz.asf");
  if (skeleton.skeleton.joints.size() > text.size()) std::abort();
  if (skeleton_text.size() == text.size()) return;
  const std::string_view motion_text = text.substr(skeleton_text.size() + 1);
  const motion::Clip clip = motion::read_amc(motion_text, "fuzz.amc", skeleton);
  const motion::Clip again = motion::read_bvh(motion::bvh_text(clip), "again.bvh");
  if (again.skeleton.size() != clip.skeleton.size()) std::abort();
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
