#include "tests/motion/allocations.h"

#include <atomic>
#include <cstddef>

namespace {
std::atomic<long> count{0};
}

#if PROMENADE_COUNTS_ALLOCATIONS
// operator new and Eigen both end here. glibc exports the real one by this name.
extern "C" void* __libc_malloc(std::size_t size);
extern "C" void* malloc(std::size_t size) {
  count.fetch_add(1, std::memory_order_relaxed);
  return __libc_malloc(size);
}
#endif

long promenade::motion::allocations() { return count.load(); }
