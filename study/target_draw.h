// Targets made by lot ([O] 6 made its five so; docs/methods.md, 3): walks of a set by random
// parameters of a model, those that begin too near the start drawn again, and of many the few
// that differ most. Everything follows from the generator that is given.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "study/adjective_model.h"
#include "study/fairness.h"

namespace promenade::study {

// What is random about a target. Ours, but for the first.
enum class DrawModel {
  adjectives,  // the sliders of the adjectives, each uniform over its range ([O] 6)
  features,    // the same of the clusters of features
  weights,     // three walks chosen by lot, their shares uniform over all that sum to 1
  pca,         // the components of the map, normal as those of the examples, inside its bounds
  examples     // a walk of the set as it is, none of them twice
};

using DrawWalk = std::function<Eigen::VectorXd(Rng&)>;  // N weights that sum to 1

// Or why this set cannot be drawn from. Without an adjective model there are no adjectives.
struct WalkSource {
  DrawWalk draw;
  std::string problem;  // empty: none
};
WalkSource make_walk_source(DrawModel model, const motion::MotionSpace& space,
                            const AdjectiveModel* adjectives);

// D at the start from which a drawn target is far enough, metres, where the task says no number:
// the automatic threshold over 0.8, but never more than what a quarter of the walks of the
// source reach. So that threshold is one number, whatever is drawn later.
double usual_least_start(const motion::MotionSpace& space, const motion::PoseBank& bank,
                         const DrawWalk& draw, DistanceTimes times);

// How many of 200 walks of the source begin at `least_start_m` or further away.
constexpr int tried_starts = 200;
int count_far_starts(const motion::PoseBank& bank, const DrawWalk& draw, DistanceTimes times,
                     double least_start_m);

// How many of the walks of the set themselves begin so far away, too.
int count_far_examples(const motion::PoseBank& bank, DistanceTimes times, double least_start_m);

struct DrawRules {
  int draws = 30;            // so many walks
  int kept = 5;              // of which those that differ most are kept
  double least_start_m = 0;  // D at the start
  DistanceTimes times = DistanceTimes::time;
};

// The kept ones, no walk twice as long as the source has others: first the one that is farthest
// from the start, then again and again the one whose nearest neighbour among them is farthest in D;
// at last they are shuffled.
std::vector<Eigen::VectorXd> draw_targets(const motion::PoseBank& bank, const DrawWalk& draw,
                                          const DrawRules& rules, Rng& rng);

// The rule behind it: indices of `kept` of the points, in the order in which they are taken.
std::vector<int> farthest_points(const std::vector<motion::DistancePoints>& points,
                                 const motion::DistancePoints& start, int kept);

}  // namespace promenade::study
