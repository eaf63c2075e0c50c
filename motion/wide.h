// Inner loops that are compiled twice, for any x86-64 and for those with AVX2; the program
// chooses as it runs, so that one binary runs everywhere. Whoever uses this keeps to one
// rule: each number is computed by the same operations in the same order in both, so that
// the digits do not depend on the machine (no fused multiply-add, no reordered sums).
#pragma once

namespace promenade::motion {

// A few doubles that the compiler keeps in one register of so many bytes.
template <int bytes>
struct Packed {
  using Numbers [[gnu::vector_size(bytes), gnu::aligned(8), gnu::may_alias]] = double;
};

constexpr int narrow_bytes = 16;  // SSE2, NEON

#if defined(__x86_64__)
#define PROMENADE_WIDE [[gnu::target("avx2")]]
constexpr int wide_bytes = 32;
inline bool has_wide() { return __builtin_cpu_supports("avx2") != 0; }
#else
#define PROMENADE_WIDE
constexpr int wide_bytes = narrow_bytes;
inline bool has_wide() { return false; }
#endif

}  // namespace promenade::motion
