#include "motion/distance.h"

namespace promenade::motion {

DistancePoints distance_points(const MotionSet& set, const Cycle& cycle) {
  DistancePoints points;
  for (int t = 0; t < distance_samples; ++t) {
    const double share = static_cast<double>(t) / (distance_samples - 1);
    const double phase = phase_at(set, cycle, share * cycle.seconds);
    const WorldPose world = forward_kinematics(set.skeleton, pose_at(set, cycle, phase));
    points.middleCols<body_joint_count>(t * body_joint_count) = body_positions(set.body, world);
  }
  return points;
}

Distance distance(const DistancePoints& a, const DistancePoints& b) {
  const double sum = (a - b).colwise().norm().sum();
  return {sum / static_cast<double>(DistancePoints::ColsAtCompileTime), sum};
}

Distance distance(const MotionSet& set, const Cycle& a, const Cycle& b) {
  return distance(distance_points(set, a), distance_points(set, b));
}

}  // namespace promenade::motion
