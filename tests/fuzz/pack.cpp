// Any bytes as a packed study: refused, or a pack that is written again as it was. A good
// hash is put over the content, or the fuzzer would never get past it. What a pack holds is
// read too, by the readers of a set, a study and its parts.
#include "study/pack.h"

#include <cstdint>
#include <cstdlib>
#include <string>

#include "motion/bytes.h"
#include "motion/problem.h"
#include "study/identity.h"

namespace {

using namespace promenade;

constexpr std::size_t head = 84;  // magic, version, size, hash
constexpr std::size_t size_at = 12, hash_at = 20;

std::string sealed(std::string bytes) {
  if (bytes.size() < head) return bytes;
  ByteWriter size;
  size.u64(bytes.size() - head);
  bytes.replace(size_at, 8, size.take());
  bytes.replace(hash_at, 64, study::sha256_hex(std::string_view(bytes).substr(head)));
  return bytes;
}

void read(const std::string& bytes) {
  const study::Pack pack = study::read_pack(bytes, "fuzz.study");
  if (study::to_bytes(pack) != bytes) std::abort();
  study::unpack_study(bytes, "fuzz.study", study::InterfaceRegistry());
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
