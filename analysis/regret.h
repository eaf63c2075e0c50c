// Fair targets: how close an interface can bring anyone to a target at all, and what a person
// left of that. D of 4 cm says little about an interface that cannot do better than 3.5 cm.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "analysis/dataset.h"

namespace promenade::study {
class InterfaceRegistry;
struct StudyBundle;
}  // namespace promenade::study

namespace promenade::analysis {

// The smallest D that a search over an interface found for a target (docs/methods.md, 3).
struct BestReachable {
  std::string task, target, interface;
  double best_m = 0;
};

struct Reachability {
  std::vector<BestReachable> rows;  // in the order of the study
  // Why there are none, or not all: a sentence; empty: all targets with a motion are there.
  std::string missing;

  std::optional<double> best(const std::string& task, const std::string& target,
                             const std::string& interface) const;
};

// Of the study as a database holds it, from the very motions in it; null: it cannot be read. The
// same every time. Targets drawn anew for each participant have none.
Reachability find_reachable(const study::StudyBundle* stored,
                            const study::InterfaceRegistry& registry);

// The measure `regret`, metres: final D minus the best that the interface can reach. A person
// can be a little better than the search was, so that it is below zero. Nothing is added when
// there is nothing to compare with.
void add_regret(const Reachability& reachability, Dataset& data);

}  // namespace promenade::analysis
