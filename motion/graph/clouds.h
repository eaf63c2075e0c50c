// What the distance of motion graphs looks at: a cloud of points for every frame of a
// take, each point with its weight ([K] 3.1; which points and weights is ours).
#pragma once

#include "motion/clip.h"
#include "motion/take.h"

namespace promenade::motion {

struct Clouds {
  Eigen::Matrix3Xd points;  // 3 x (T P): point m of frame f in column f P + m; Y up
  Eigen::VectorXd weights;  // P, positive

  int points_per_frame() const { return static_cast<int>(weights.size()); }
  int frames() const {
    return weights.size() == 0 ? 0 : static_cast<int>(points.cols() / weights.size());
  }
};

// Every joint of the clip, in file units, with Y up ((x, z, -y) where Z is up); weights 1. The
// second: of so many frames from `first` on.
Clouds joint_clouds(const Clip& clip, bool z_up);
Clouds joint_clouds(const Clip& clip, bool z_up, int first, int frames);

// 20, of the body's joints, sum 1: those of the next function for a skeleton that is the body.
Eigen::VectorXd body_weights();

// P = J, sum 1: each joint carries the mass of the segments that end at it (de Leva 1996), the
// feet three times theirs, since sliding feet are what people see first. Joints beyond the
// body carry a hundredth of the mean, so that no point is without weight.
Eigen::VectorXd joint_weights(const Skeleton& skeleton, const BodyMap& body);

// Every joint of the take, metres, with those weights.
Clouds joint_clouds(const Take& take, const Eigen::VectorXd& weights);

}  // namespace promenade::motion
