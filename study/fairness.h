// How far targets are and what can be reached: what makes a match task fair
// (docs/methods.md, 3). A threshold belongs to a motion set.
#pragma once

#include "study/study.h"

namespace promenade::study {

using motion::DistanceTimes;

// D between the blends of two weight vectors, metres.
double weights_distance(const motion::MotionSpace& space, const Eigen::VectorXd& a,
                        const Eigen::VectorXd& b, DistanceTimes times = DistanceTimes::time);

// What D compares of the blend, as `motion::distance` wants it.
motion::DistancePoints blend_points(const motion::PoseBank& bank, const Eigen::VectorXd& weights,
                                    DistanceTimes times = DistanceTimes::time);

// D of a target at the state in which trials begin.
double start_distance(const motion::MotionSpace& space, const Eigen::VectorXd& target,
                      DistanceTimes times = DistanceTimes::time);

// Median of D over all pairs of examples of different styles (of all pairs when there
// is one style), metres; 0 for a set of one cycle.
double median_style_distance(const motion::MotionSpace& space,
                             DistanceTimes times = DistanceTimes::time);

// threshold = "auto": half the median distance between styles, but never more than
// 0.8 times the D from which the nearest target of the task starts. Targets that are drawn for
// each participant start at Target::least_start_m or further away.
constexpr double start_margin = 0.8;
double automatic_threshold(const motion::MotionSpace& space, const Task& task);

// What one interface can do about one target.
struct Reach {
  double start = 0;         // D at the start, metres
  double best = 0;          // smallest D that a search over the interface found
  double best_example = 0;  // smallest D of an unblended example
  double share_below = 0;   // of random settings that are below the threshold
  int settings = 0;         // how many were tried for that share
};

// Searches with what InterfaceType::simulate proposes: random settings first, then
// always the best proposal until `rounds` rounds bring nothing. `share_below` is of the
// threshold, metres. Deterministic.
struct ReachOptions {
  double threshold_m = 0;
  int settings = 200, rounds = 40;
};
Reach reach(const StudyBundle& bundle, const InterfaceRegistry& registry, const Task& task,
            int interface, const Target& target, const ReachOptions& options);

}  // namespace promenade::study
