// The inner loops of a distance map, in single precision, compiled for three instruction sets; the
// widest that the processor has is chosen as the program runs, so that one binary serves every
// x86-64. Sums may be fused and are as long as a register, so the sets differ in the last digits:
// a map only says where to look, and whoever reports a number asks window_distance() again.
//
// Numbers of three kinds come for every pair of frames (f of A, g of B), points m with weights w:
//   C = sum w (x x' + z z'),  S = sum w (x z' - x' z),  Y = sum w y y'.
#pragma once

#include <vector>

namespace promenade::motion {

enum class Instructions { sse2, avx2, avx512 };

std::vector<Instructions> usable_instructions();  // of this processor, the widest last
const char* name_of(Instructions instructions);

// Frames of B lie in panels of 32: of each point 32 x, 32 z, 32 y. Frames of A lie in fours: of
// each point w x, w z, w y of the first frame, then of the others.
constexpr int panel_frames = 32;
constexpr int panel_floats = 3 * panel_frames;  // of a point
constexpr int four_floats = 3 * 4;

// One row of numbers for each kind.
template <typename Number>
struct ThreeRows {
  Number *c, *s, *y;
};

struct WindowRow {                 // what the windows of one row of the map know before they meet
  float spread, x, z;              // of A's window: see WindowMoments
  const float *spreads, *xs, *zs;  // of B's windows
};

struct MapKernels {
  // Numbers of four frames of A with 32 frames of B, to rows[0..3].
  void (*products)(int points, const float* four, const float* panel, const ThreeRows<float>* rows);
  // sums[n] += entering[n] - leaving[n].
  void (*slide)(int count, ThreeRows<const float> entering, ThreeRows<const float> leaving,
                ThreeRows<float> sums);
  // sums[n] = sum over p of taper[p] rows[p][n + p].
  void (*weigh)(int count, int window, const float* taper, const ThreeRows<float>* rows,
                ThreeRows<float> sums);
  // Mean squares of the distances of windows, from their sums; never below zero.
  void (*finish)(int count, ThreeRows<const float> sums, const WindowRow& row, float* out);
  // out[n] = the least of the eight neighbours of row[n].
  void (*least_neighbours)(int count, const float* above, const float* row, const float* below,
                           float* out);
};

const MapKernels& map_kernels(Instructions instructions = usable_instructions().back());

}  // namespace promenade::motion
