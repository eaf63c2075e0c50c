// The way from weights to what is shown: weights to a pose at a phase, to D, to a whole
// cycle. What `blend(space, weights)` gives, to 1e-9, several times as fast, and without
// an allocation once the buffers exist. Phases of the cycle are made when they are
// first asked for and kept while the weights are: a walking figure makes them one by
// one, D the 22 that it needs.
#pragma once

#include "motion/distance.h"
#include "motion/motion_space.h"

namespace promenade::motion {

// A motion space, ordered for that: made once, never changed.
struct PoseBank {
  MotionSet set;                // its cycles have only their keytimes
  int lanes = 0;                // J, rounded up to 8: room for one component of all joints
  int rows = 0;                 // 3 lanes, rounded up to 16: all x, then all y, then all z
  Eigen::MatrixXd offsets;      // (rows N) x F: a phase in a column, in blocks of 16 rows; a
                                // block holds them of cycle 0, then of cycle 1, and so on
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
  Eigen::MatrixXd phases;   // lanes x (4 F): x, y, z, w of the phases made so far
  Eigen::Array<bool, Eigen::Dynamic, 1> made;  // F: which these are
  Eigen::VectorXd offsets;                     // of one phase: scratch
  Eigen::MatrixXd rotations;                   // lanes x 4, between them
  Eigen::VectorXd times, mixed_root;           // F+1, 3 F
  Pose pose;                                   // scratch of distance_points
  WorldPose world;
};

// Starts with equal weights.
PoseBlend make_pose_blend(const PoseBank& bank);

// Weights (N, sum 1; negative ones are allowed) decide the timing and the path.
void set_weights(const PoseBank& bank, const Eigen::VectorXd& weights, PoseBlend& blend);

// The pose at a phase (wraps around), walking on the spot. `pose` keeps its memory.
void pose_at(const PoseBank& bank, PoseBlend& blend, double phase, Pose& pose);

// The whole cycle in canonical form: what `blend` returns. `cycle` keeps its memory.
void blended_cycle(const PoseBank& bank, PoseBlend& blend, Cycle& cycle);

// What D compares ([O] Eq. 8), of the blend.
void distance_points(const PoseBank& bank, PoseBlend& blend, DistancePoints& points,
                     DistanceTimes times = DistanceTimes::time);

}  // namespace promenade::motion
