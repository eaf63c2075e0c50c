// Weights to a pose at a phase without blending the whole cycle: only the two
// neighbouring phases are. What `pose_at(set, blend(space, weights), phase)` gives, to
// 1e-9, about a hundred times as fast, and without an allocation once the buffers
// exist. A figure on screen, D while a control moves and the search for reachable
// targets use it.
#pragma once

#include "motion/distance.h"
#include "motion/motion_space.h"

namespace promenade::motion {

// A motion space, ordered for that: made once, never changed.
struct PoseBank {
  MotionSet set;                // its cycles have only their keytimes
  int lanes = 0;                // J, rounded up: room for one component of all joints
  Eigen::MatrixXd offsets;      // 3 lanes x (F N): columns f N to f N + N - 1 are phase f;
                                // all x, then all y, then all z
  Eigen::MatrixXd average;      // lanes x (4 F): columns 4 f to 4 f + 3 are x, y, z, w
  Eigen::MatrixXd root;         // 3 F x N, metres: height, then planar velocity left and
                                // ahead, per unit of normalised time
  Eigen::VectorXd mean_height;  // F, metres

  int size() const { return set.size(); }
};

PoseBank make_pose_bank(const MotionSpace& space);

// The buffers of one figure.
struct PoseBlend {
  Eigen::VectorXd weights;  // N
  Cycle timing;             // keytimes, seconds and mean velocity; no rotations
  Eigen::Matrix3Xd root;    // 3 x F, metres, as Cycle::root
  struct Phase {
    int index = -1;             // which one; -1: to be made anew
    Eigen::VectorXd offsets;    // 3 lanes
    Eigen::MatrixXd rotations;  // lanes x 4: x, y, z, w
  };
  Phase before, after;                // kept while the weights are: a walk makes one at a time
  Eigen::MatrixXd rotations;          // lanes x 4, between them
  Eigen::VectorXd times, mixed_root;  // F+1, 3 F: scratch
  Pose pose;                          // scratch of distance_points
  WorldPose world;
};

// Starts with equal weights.
PoseBlend make_pose_blend(const PoseBank& bank);

// Weights (N, sum 1; negative ones are allowed) decide the timing and the path.
void set_weights(const PoseBank& bank, const Eigen::VectorXd& weights, PoseBlend& blend);

// The pose at a phase (wraps around), walking on the spot. `pose` keeps its memory.
void pose_at(const PoseBank& bank, PoseBlend& blend, double phase, Pose& pose);

// What D compares ([O] Eq. 8), of the blend.
void distance_points(const PoseBank& bank, PoseBlend& blend, DistancePoints& points);

}  // namespace promenade::motion
