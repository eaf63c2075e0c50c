// The distance D of two cycles ([O] Eq. 8; docs/methods.md, 2): the mean over 11 times
// and 20 joints of the distance of the joints, in metres. Each cycle runs over
// its own duration (or, on request, through common phases); the mean velocity of the pelvis is
// taken out and its mean horizontal position is the origin, while its sway stays.
#pragma once

#include "motion/motion_set.h"

namespace promenade::motion {

inline constexpr int distance_samples = 11;  // T + 1, T = 10

// 3 x 220, metres: what D compares, made once for a cycle that is compared often.
using DistancePoints = Eigen::Matrix<double, 3, distance_samples * body_joint_count>;

// When the two cycles are compared: at shares of their own durations, as Eq. 8 prints it, or
// at common phases, so that keytimes meet ("poses at keytimes" says the text of [O]).
enum class DistanceTimes { time, phase };

// The phase of sample t, 0 to 10.
double distance_phase(const MotionSet& set, const Cycle& timing, DistanceTimes times, int sample);

DistancePoints distance_points(const MotionSet& set, const Cycle& cycle,
                               DistanceTimes times = DistanceTimes::time);

struct Distance {
  double mean_m = 0;  // D: the threshold of the studies is about this
  double sum_m = 0;   // the bare sum that Eq. 8 prints
};

Distance distance(const DistancePoints& a, const DistancePoints& b);
Distance distance(const MotionSet& set, const Cycle& a, const Cycle& b,
                  DistanceTimes times = DistanceTimes::time);

}  // namespace promenade::motion
