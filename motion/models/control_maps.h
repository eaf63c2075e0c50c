// The five interfaces as maps from their controls to weights, without a user
// interface: what a search for reachable targets and commands need of them
// (docs/methods.md, 10). Start here to see what each interface can do.
//
//   map         x, y on the minimap; the other components settled on those of the
//               nearest example (heuristic "closest", long after the move)
//   labels      one of N examples
//   adjectives  a slider from 0 to 1 for each primary adjective parameter
//   features    the same for each cluster of motion features
//   weights     a slider from 0 to 1 for each example, divided by their sum
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "motion/models/map.h"
#include "motion/models/radial_basis.h"
#include "motion/models/reach.h"
#include "motion/models/ward.h"

namespace promenade::motion {

struct ControlMap {
  std::string name;
  std::vector<std::string> controls;  // names of its parameters
  // Guesses know where a target lies: they are those of its weights, if it has any.
  ReachProblem problem;
  std::function<Eigen::VectorXd(const Eigen::VectorXd& target)> guess;  // N weights to P
  bool shows_examples = false;  // each can be had as it is, beside what the parameters reach
};

// Nothing for a set whose cycles are all alike.
std::optional<ControlMap> map_controls(const MotionSpace& space, const MapOptions& = {});
ControlMap label_controls(const MotionSet& set);
ControlMap weight_controls(const MotionSet& set);

// Sliders whose values at the examples are known: P x N, in 0 to 1 (adjectives or
// features). `controls` has P names.
ControlMap slider_controls(const std::string& name, const std::vector<std::string>& controls,
                           const Eigen::MatrixXd& parameters,
                           NegativeRule rule = NegativeRule::clamp);

// The sliders of the features of a set: its clusters of them (standardised, Ward), named as
// the source named those that they overlap with, and their means over the range of the set.
struct FeatureSliders {
  std::vector<std::string> names;  // C
  std::vector<double> agreement;   // C: with the printed cluster of that name, 0 to 1
  std::vector<int> cluster;        // 51: 0 to C-1
  Eigen::MatrixXd parameters;      // C x N, 0 to 1
  Dendrogram tree;                 // of the 51
};
FeatureSliders feature_sliders(const MotionSet& set, int clusters = 4);

// The problem of a target (N weights), with the guesses that it suggests.
ReachProblem problem_of(const ControlMap& map, const Eigen::VectorXd& target);

}  // namespace promenade::motion
