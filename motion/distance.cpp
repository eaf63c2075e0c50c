#include "motion/distance.h"

namespace promenade::motion {

double distance_phase(const MotionSet& set, const Cycle& timing, DistanceTimes times, int sample) {
  const double share = static_cast<double>(sample) / (distance_samples - 1);
  return times == DistanceTimes::phase ? share : phase_at(set, timing, share * timing.seconds);
}

DistancePoints distance_points(const MotionSet& set, const Cycle& cycle, DistanceTimes times) {
  DistancePoints points;
  for (int t = 0; t < distance_samples; ++t) {
    const double phase = distance_phase(set, cycle, times, t);
    const WorldPose world = forward_kinematics(set.skeleton, pose_at(set, cycle, phase));
    points.middleCols<body_joint_count>(t * body_joint_count) = body_positions(set.body, world);
  }
  return points;
}

Distance distance(const DistancePoints& a, const DistancePoints& b) {
  const double sum = (a - b).colwise().norm().sum();
  return {sum / static_cast<double>(DistancePoints::ColsAtCompileTime), sum};
}

Distance distance(const MotionSet& set, const Cycle& a, const Cycle& b, DistanceTimes times) {
  return distance(distance_points(set, a, times), distance_points(set, b, times));
}

}  // namespace promenade::motion
