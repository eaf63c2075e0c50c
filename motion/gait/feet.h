// Footfalls, and the path of a foot between them. On the ground a foot turns
// about the point that bears it: the heel until the sole is flat, then nothing
// moves, then the toe joint while the heel rises. So it cannot slide.
#pragma once

#include <Eigen/Geometry>

#include "motion/gait/figure.h"
#include "motion/gait/style.h"

namespace promenade::motion::gait {

struct FootPose {
  Eigen::Vector3d ankle;    // m
  Eigen::Quaterniond turn;  // of the foot, in the world
  double toes_up = 0;       // degrees that the toes are bent up against the foot
};

// Stride at which the heel strikes first: 0 at the right.
double strike_of(const GaitStyle& style, Side side);

// Share of the foot's own stride, 0 to 1, at a time of any stride.
double own_share(const GaitStyle& style, Side side, double stride);

// Degrees that the toes are up, at a share of the foot's own stride.
double foot_pitch(const GaitStyle& style, double share);

// At a stride that counts on (2.25 is in the third stride); +Z is ahead and the
// pelvis passes z = 0 at 0.
FootPose foot_pose(const GaitStyle& style, Side side, double stride);

}  // namespace promenade::motion::gait
