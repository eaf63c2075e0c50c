#include "motion/pose_kernel.h"

#include <algorithm>
#include <cmath>

namespace promenade::motion {
namespace {

template <int bytes>
using Numbers = typename Packed<bytes>::Numbers;

template <int bytes>
[[gnu::always_inline]] inline Numbers<bytes>& pack(double* at) {
  return *reinterpret_cast<Numbers<bytes>*>(at);
}

template <int bytes>
[[gnu::always_inline]] inline const Numbers<bytes>& pack(const double* at) {
  return *reinterpret_cast<const Numbers<bytes>*>(at);
}

// A block's sums stay in registers: eight of 16 bytes or four of 32.
template <int bytes>
[[gnu::always_inline]] inline void mix(const PhaseOffsets& phase, double* mixed) {
  constexpr int packs = rows_of_a_block * 8 / bytes;
  const double* from = phase.offsets;
  for (int row = 0; row < phase.rows; row += rows_of_a_block) {
    Numbers<bytes> sum[packs] = {};
    for (int i = 0; i < phase.cycles; ++i, from += rows_of_a_block) {
      const double weight = phase.weights[i];
      for (int k = 0; k < packs; ++k) sum[k] += weight * pack<bytes>(from + k * bytes / 8);
    }
    for (int k = 0; k < packs; ++k) pack<bytes>(mixed + row + k * bytes / 8) = sum[k];
  }
}

// cos(sqrt t) and sin(sqrt t)/sqrt t as series in t: no root, no branch. The remainder of
// `terms` terms is below 1e-16 for t up to `reach`.
struct SeriesSize {
  double reach;
  int terms;
};
constexpr SeriesSize series_sizes[] = {{0.06, 6}, {0.3, 8}, {2.6, 13}};

template <int terms>
struct Series {
  double cosine[terms] = {1};
  double sine[terms] = {1};
  constexpr Series() {
    for (int n = 1; n < terms; ++n) {
      cosine[n] = -cosine[n - 1] / (2 * n * (2 * n - 1));
      sine[n] = cosine[n] / (2 * n + 1);
    }
  }
};

template <int bytes, int terms>
[[gnu::always_inline]] inline void series_exponential(int lanes, const double* turn,
                                                      double* rotation) {
  constexpr Series<terms> series;
  for (int j = 0; j < lanes; j += bytes / 8) {
    const Numbers<bytes> x = 0.5 * pack<bytes>(turn + j);
    const Numbers<bytes> y = 0.5 * pack<bytes>(turn + lanes + j);
    const Numbers<bytes> z = 0.5 * pack<bytes>(turn + 2 * lanes + j);
    const Numbers<bytes> t = x * x + y * y + z * z;
    Numbers<bytes> c = series.cosine[terms - 1] + 0 * t;
    Numbers<bytes> s = series.sine[terms - 1] + 0 * t;
    for (int n = terms - 2; n >= 0; --n) {
      c = c * t + series.cosine[n];
      s = s * t + series.sine[n];
    }
    pack<bytes>(rotation + j) = s * x;
    pack<bytes>(rotation + lanes + j) = s * y;
    pack<bytes>(rotation + 2 * lanes + j) = s * z;
    pack<bytes>(rotation + 3 * lanes + j) = c;
  }
}

void exact_exponential(int lanes, const double* turn, double* rotation) {
  for (int j = 0; j < lanes; ++j) {
    const double x = 0.5 * turn[j];
    const double y = 0.5 * turn[lanes + j];
    const double z = 0.5 * turn[2 * lanes + j];
    const double angle = std::sqrt(x * x + y * y + z * z);
    const double scale = angle > 1e-12 ? std::sin(angle) / angle : 1;
    rotation[j] = scale * x;
    rotation[lanes + j] = scale * y;
    rotation[2 * lanes + j] = scale * z;
    rotation[3 * lanes + j] = std::cos(angle);
  }
}

double largest_square(int lanes, const double* turn) {
  double largest = 0;
  for (int j = 0; j < lanes; ++j) {
    const double x = turn[j];
    const double y = turn[lanes + j];
    const double z = turn[2 * lanes + j];
    largest = std::max(largest, x * x + y * y + z * z);
  }
  return largest;
}

// Unit quaternions (lanes x 4) of rotation vectors (3 lanes).
template <int bytes>
[[gnu::always_inline]] inline void exponential(int lanes, const double* turn, double* rotation) {
  const double t = 0.25 * largest_square(lanes, turn);
  if (t <= series_sizes[0].reach) {
    series_exponential<bytes, series_sizes[0].terms>(lanes, turn, rotation);
  } else if (t <= series_sizes[1].reach) {
    series_exponential<bytes, series_sizes[1].terms>(lanes, turn, rotation);
  } else if (t <= series_sizes[2].reach) {
    series_exponential<bytes, series_sizes[2].terms>(lanes, turn, rotation);
  } else {
    exact_exponential(lanes, turn, rotation);
  }
}

// r = q r for each lane.
template <int bytes>
[[gnu::always_inline]] inline void turn_by(int lanes, const double* q, double* r) {
  for (int j = 0; j < lanes; j += bytes / 8) {
    const Numbers<bytes> ax = pack<bytes>(q + j), ay = pack<bytes>(q + lanes + j);
    const Numbers<bytes> az = pack<bytes>(q + 2 * lanes + j), aw = pack<bytes>(q + 3 * lanes + j);
    const Numbers<bytes> bx = pack<bytes>(r + j), by = pack<bytes>(r + lanes + j);
    const Numbers<bytes> bz = pack<bytes>(r + 2 * lanes + j), bw = pack<bytes>(r + 3 * lanes + j);
    pack<bytes>(r + j) = aw * bx + ax * bw + ay * bz - az * by;
    pack<bytes>(r + lanes + j) = aw * by + ay * bw + az * bx - ax * bz;
    pack<bytes>(r + 2 * lanes + j) = aw * bz + az * bw + ax * by - ay * bx;
    pack<bytes>(r + 3 * lanes + j) = aw * bw - ax * bx - ay * by - az * bz;
  }
}

template <int bytes>
[[gnu::always_inline]] inline void blend_phase(const PhaseOffsets& phase, double* mixed,
                                               double* rotations) {
  mix<bytes>(phase, mixed);
  exponential<bytes>(phase.lanes, mixed, rotations);
  turn_by<bytes>(phase.lanes, phase.average, rotations);
}

void blend_phase_narrow(const PhaseOffsets& phase, double* mixed, double* rotations) {
  blend_phase<narrow_bytes>(phase, mixed, rotations);
}

PROMENADE_WIDE void blend_phase_wide(const PhaseOffsets& phase, double* mixed, double* rotations) {
  blend_phase<wide_bytes>(phase, mixed, rotations);
}

}  // namespace

void blend_rotations(const PhaseOffsets& phase, double* mixed, double* rotations, bool wide) {
  return wide ? blend_phase_wide(phase, mixed, rotations)
              : blend_phase_narrow(phase, mixed, rotations);
}

}  // namespace promenade::motion
