// Any bytes as a file of test vectors: refused, or every case has an entry of its own.
#include "analysis/vectors.h"

#include <cstdint>
#include <cstdlib>

#include "motion/problem.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  try {
    const std::string results = promenade::analysis::run_vectors("fuzz.json", text);
    if (results.rfind("{\n \"results\": ", 0) != 0 || results.back() != '\n') std::abort();
  } catch (const promenade::InputError&) {
    // Refused with a place and a reason: that is what should happen.
  }
  return 0;
}
