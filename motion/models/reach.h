// What an interface can do for a target at best, at its start, and by luck: the three
// figures that make a target fair between interfaces (docs/methods.md, 10). An interface is a
// map from its parameters to weights; no user interface is needed.
#pragma once

#include <functional>
#include <vector>

#include "motion/models/search.h"
#include "motion/pose_blender.h"

namespace promenade::motion {

// Parameters to N weights that sum to 1; `weights` has N.
using WeightsMap = std::function<void(const Eigen::VectorXd& parameters, Eigen::VectorXd& weights)>;

struct ReachProblem {
  WeightsMap weights;
  Box box;                // where the parameters can be
  Eigen::VectorXd start;  // N, the weights before anything is touched
  // Parameters that are worth a search of their own, best first or not.
  std::vector<Eigen::VectorXd> guesses = {};
  // Not empty: an interface of finitely many settings. Each is tried, instead of
  // random ones and searches; parameter 0 is its index.
  std::vector<Eigen::VectorXd> choices = {};
};

struct ReachOptions {
  double threshold_m = 0.06;
  DistanceTimes times = DistanceTimes::time;  // as those of the target's points
  int random_settings = 500;
  int searches = 6;  // from the middle of the box, the two best guesses, the best random
                     // settings
  SearchOptions search = {};
};

struct Reach {
  double best_m = 0;             // least D that was found: an upper bound of the best
  Eigen::VectorXd best_at;       // its parameters
  double start_m = 0;            // D of the start weights
  double share_below = 0;        // of the random settings with D < threshold
  std::vector<double> random_m;  // D of each random setting, or of each choice
};

// `uniform` draws from [0, 1): the caller's generator makes it reproducible.
Reach reach(const PoseBank& bank, const DistancePoints& target, const ReachProblem& problem,
            const std::function<double()>& uniform, const ReachOptions& = {});

}  // namespace promenade::motion
