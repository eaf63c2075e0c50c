#include "motion/graph/map_kernels.h"

#include <algorithm>
#include <cmath>

namespace promenade::motion {
namespace {

// A few floats that the compiler keeps in one register of so many bytes.
template <int bytes>
struct Floats {
  using Numbers [[gnu::vector_size(bytes), gnu::aligned(4), gnu::may_alias]] = float;
};

#define PROMENADE_INLINE [[gnu::always_inline]] inline

// `vectors` registers of B's frames against four frames of A: all sums stay in registers.
template <int bytes, int vectors>
PROMENADE_INLINE void some_products(int points, const float* four, const float* panel,
                                    const ThreeRows<float>* rows, int first) {
  using Numbers = typename Floats<bytes>::Numbers;
  constexpr int lanes = bytes / 4;
  Numbers c[4][vectors] = {}, s[4][vectors] = {}, y[4][vectors] = {};
  for (int m = 0; m < points; ++m, four += four_floats, panel += panel_floats) {
    for (int v = 0; v < vectors; ++v) {
      const float* const at = panel + v * lanes;
      const auto px = *reinterpret_cast<const Numbers*>(at);
      const auto pz = *reinterpret_cast<const Numbers*>(at + panel_frames);
      const auto py = *reinterpret_cast<const Numbers*>(at + 2 * panel_frames);
      for (int r = 0; r < 4; ++r) {
        const float x = four[3 * r], z = four[3 * r + 1], h = four[3 * r + 2];
        c[r][v] += x * px;
        c[r][v] += z * pz;
        s[r][v] += x * pz;
        s[r][v] -= z * px;
        y[r][v] += h * py;
      }
    }
  }
  for (int r = 0; r < 4; ++r) {
    for (int v = 0; v < vectors; ++v) {
      *reinterpret_cast<Numbers*>(rows[r].c + first + v * lanes) = c[r][v];
      *reinterpret_cast<Numbers*>(rows[r].s + first + v * lanes) = s[r][v];
      *reinterpret_cast<Numbers*>(rows[r].y + first + v * lanes) = y[r][v];
    }
  }
}

template <int bytes, int vectors>
PROMENADE_INLINE void products(int points, const float* four, const float* panel,
                               const ThreeRows<float>* rows) {
  constexpr int step = vectors * bytes / 4;
  for (int first = 0; first < panel_frames; first += step) {
    some_products<bytes, vectors>(points, four, panel + first, rows, first);
  }
}

PROMENADE_INLINE void slide_one(int count, const float* __restrict entering,
                                const float* __restrict leaving, float* __restrict sums) {
  for (int n = 0; n < count; ++n) sums[n] += entering[n] - leaving[n];
}

PROMENADE_INLINE void slide(int count, ThreeRows<const float> entering,
                            ThreeRows<const float> leaving, ThreeRows<float> sums) {
  slide_one(count, entering.c, leaving.c, sums.c);
  slide_one(count, entering.s, leaving.s, sums.s);
  slide_one(count, entering.y, leaving.y, sums.y);
}

// Rows have room for a register more than `count`.
template <int bytes>
PROMENADE_INLINE void weigh(int count, int window, const float* taper, const ThreeRows<float>* rows,
                            ThreeRows<float> sums) {
  using Numbers = typename Floats<bytes>::Numbers;
  for (int n = 0; n < count; n += bytes / 4) {
    Numbers c = {}, s = {}, y = {};
    for (int p = 0; p < window; ++p) {
      c += taper[p] * *reinterpret_cast<const Numbers*>(rows[p].c + n + p);
      s += taper[p] * *reinterpret_cast<const Numbers*>(rows[p].s + n + p);
      y += taper[p] * *reinterpret_cast<const Numbers*>(rows[p].y + n + p);
    }
    *reinterpret_cast<Numbers*>(sums.c + n) = c;
    *reinterpret_cast<Numbers*>(sums.s + n) = s;
    *reinterpret_cast<Numbers*>(sums.y + n) = y;
  }
}

PROMENADE_INLINE void finish(int count, ThreeRows<const float> sums, const WindowRow& row,
                             float* __restrict out) {
  const float spread = row.spread, x = row.x, z = row.z;
  const float* __restrict spreads = row.spreads;
  const float* __restrict xs = row.xs;
  const float* __restrict zs = row.zs;
  for (int n = 0; n < count; ++n) {
    const float c = sums.c[n] - (x * xs[n] + z * zs[n]);
    const float s = sums.s[n] - (x * zs[n] - z * xs[n]);
    const float square = spread + spreads[n] - 2 * (std::sqrt(c * c + s * s) + sums.y[n]);
    out[n] = square > 0 ? square : 0.0F;
  }
}

PROMENADE_INLINE float lesser(float a, float b) { return a < b ? a : b; }

PROMENADE_INLINE void least_neighbours(int count, const float* __restrict above,
                                       const float* __restrict row, const float* __restrict below,
                                       float* __restrict out) {
  for (int n = 0; n < count; ++n) {
    const float left = lesser(lesser(above[n - 1], below[n - 1]), row[n - 1]);
    const float right = lesser(lesser(above[n + 1], below[n + 1]), row[n + 1]);
    out[n] = lesser(lesser(above[n], below[n]), lesser(left, right));
  }
}

#define PROMENADE_KERNELS(NAME, ATTRIBUTE, BYTES, VECTORS)                                   \
  ATTRIBUTE void products_##NAME(int points, const float* four, const float* panel,          \
                                 const ThreeRows<float>* rows) {                             \
    products<BYTES, VECTORS>(points, four, panel, rows);                                     \
  }                                                                                          \
  ATTRIBUTE void slide_##NAME(int count, ThreeRows<const float> entering,                    \
                              ThreeRows<const float> leaving, ThreeRows<float> sums) {       \
    slide(count, entering, leaving, sums);                                                   \
  }                                                                                          \
  ATTRIBUTE void weigh_##NAME(int count, int window, const float* taper,                     \
                              const ThreeRows<float>* rows, ThreeRows<float> sums) {         \
    weigh<BYTES>(count, window, taper, rows, sums);                                          \
  }                                                                                          \
  ATTRIBUTE void finish_##NAME(int count, ThreeRows<const float> sums, const WindowRow& row, \
                               float* out) {                                                 \
    finish(count, sums, row, out);                                                           \
  }                                                                                          \
  ATTRIBUTE void least_neighbours_##NAME(int count, const float* above, const float* row,    \
                                         const float* below, float* out) {                   \
    least_neighbours(count, above, row, below, out);                                         \
  }                                                                                          \
  constexpr MapKernels kernels_##NAME = {products_##NAME, slide_##NAME, weigh_##NAME,        \
                                         finish_##NAME, least_neighbours_##NAME};

PROMENADE_KERNELS(sse2, , 16, 1)
#if defined(__x86_64__)
PROMENADE_KERNELS(avx2, [[gnu::target("avx2,fma")]], 32, 1)
PROMENADE_KERNELS(avx512, [[gnu::target("avx512f,fma")]], 64, 2)
#endif

}  // namespace

std::vector<Instructions> usable_instructions() {
  std::vector<Instructions> usable = {Instructions::sse2};
#if defined(__x86_64__)
  if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma")) {
    usable.push_back(Instructions::avx2);
    if (__builtin_cpu_supports("avx512f")) usable.push_back(Instructions::avx512);
  }
#endif
  return usable;
}

const char* name_of(Instructions instructions) {
  if (instructions == Instructions::avx512) return "AVX-512";
  return instructions == Instructions::avx2 ? "AVX2" : "SSE2";
}

const MapKernels& map_kernels(Instructions instructions) {
#if defined(__x86_64__)
  if (instructions == Instructions::avx512) return kernels_avx512;
  if (instructions == Instructions::avx2) return kernels_avx2;
#endif
  (void)instructions;
  return kernels_sse2;
}

}  // namespace promenade::motion
