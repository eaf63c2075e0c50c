// The inner loop of every picture and of every D: offsets of one phase mixed by weights, and
// turned into rotations (motion/pose_blender.h, which lays the memory out).
#pragma once

#include "motion/wide.h"

namespace promenade::motion {

inline constexpr int rows_of_a_block = 16;

struct PhaseOffsets {
  int lanes = 0;                    // J, rounded up to 8
  int rows = 0;                     // 3 lanes, rounded up to blocks
  int cycles = 0;                   // N
  const double* weights = nullptr;  // N
  // Blocks of 16 rows, one after another; a block holds those of cycle 0, then of cycle
  // 1, and so on. The rows are all x, then all y, then all z of rotation vectors, radians.
  const double* offsets = nullptr;
  const double* average = nullptr;  // lanes x 4: unit quaternions x, y, z, w
};

// rotations (lanes x 4) = average * exp(sum of weights times offsets); `mixed` (rows) holds
// that sum. Within 1e-15 of the definition for sums up to 3.2 radians, exact beyond. `wide`
// only where the processor can; the digits are the same either way.
void blend_rotations(const PhaseOffsets& phase, double* mixed, double* rotations,
                     bool wide = has_wide());

}  // namespace promenade::motion
