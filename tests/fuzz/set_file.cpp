// Any bytes as a motion set: refused, or a set that can be shown, blended and written
// again. A good checksum is put over the bytes, or the fuzzer would never get past it.
#include "motion/set_file.h"

#include <cstdint>
#include <cstdlib>
#include <string>

#include "motion/bytes.h"
#include "motion/cycle_clip.h"
#include "motion/motion_space.h"

namespace {

using namespace promenade;

constexpr std::size_t head = 28;  // magic, version, size, checksum
constexpr std::size_t version_at = 8, sum_at = 20, size_at = 12;
constexpr char newest_version = 2;

std::string sealed(std::string bytes) {
  if (bytes.size() < head) return bytes;
  const auto put = [&bytes](std::size_t at, std::uint64_t value) {
    ByteWriter writer;
    writer.u64(value);
    bytes.replace(at, 8, writer.take());
  };
  put(size_at, bytes.size() - head);
  put(sum_at, checksum(std::string_view(bytes).substr(head)));
  return bytes;
}

void read(const std::string& bytes) {
  const motion::MotionSet set = motion::from_bytes(bytes, "fuzz.set");
  const std::string written = motion::to_bytes(set);
  if (motion::to_bytes(motion::from_bytes(written, "again.set")) != written) std::abort();
  // A file of the older version is written as one of the newer.
  if (bytes[version_at] == newest_version && written != bytes) std::abort();
  motion::cycle_clip(set, set.cycles.back());
  const auto space = motion::make_motion_space(set);
  motion::blend(space, Eigen::VectorXd::Constant(set.size(), 1.0 / set.size()));
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  try {
    read(sealed({reinterpret_cast<const char*>(data), size}));
  } catch (const InputError&) {
    // Refused with a place and a reason: that is what should happen.
  }
  return 0;
}
