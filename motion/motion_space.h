// A motion set and what follows from it: the average cycle and the motion
// offsets, in which a blend is linear (docs/methods.md, 1; the idea is [N] 5.5).
#pragma once

#include "motion/motion_set.h"

namespace promenade::motion {

struct MotionSpace {
  MotionSet set;
  double leg_length = 1;        // metres
  Eigen::Matrix4Xd average;     // 4 x (F J): mean rotation qbar(f, j), as Cycle::rotations
  Eigen::VectorXd mean_height;  // F, metres
  // D x N, one column a cycle. Rows: 3 F J rotation offsets log(qbar^-1 q), radians
  // (joint fastest, then phase); F root heights over leg length; 2 F planar
  // velocities, over leg length and times the duration (left, ahead), each the
  // mean between phases f and f+1.
  Eigen::MatrixXd offsets;

  int shape_rows() const;  // rows that shape the map: rotations and heights
};

MotionSpace make_motion_space(MotionSet set);

// The cycle of weights w (N, sum 1; negative ones are allowed, keytimes are then
// clamped to the range of the set). A unit weight gives that example, to 1e-9.
Cycle blend(const MotionSpace& space, const Eigen::VectorXd& weights);

// The keytimes of that cycle (M+1, seconds from 0). Allocation-free when `keytimes`
// has room.
void blend_keytimes(const MotionSet& set, const Eigen::VectorXd& weights,
                    std::vector<double>& keytimes);

}  // namespace promenade::motion
