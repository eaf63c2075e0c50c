// What the adjective sliders are made of: ratings, quantified ([O] Eqs. 1-6), with a name
// for each primary parameter. Where the ratings come from simulated raters, the model
// says so, and whoever shows it does, too.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "study/ratings.h"

namespace promenade::study {

struct AdjectiveModel {
  RatingsTable table;
  motion::QuantificationOptions options;
  motion::Quantification quantification;
  std::vector<std::string> kept_pairs;  // Q: names of the pairs that are left
  std::vector<std::string> names;       // C: "quickness" and so on
  std::vector<double> name_agreement;   // C: how much each cluster is the printed one, 0 to 1
  std::string source;                   // "ratings.csv", "14 simulated raters, seed 1"

  bool simulated() const { return table.simulated; }
};

AdjectiveModel make_adjective_model(RatingsTable table, const std::string& source,
                                    const motion::QuantificationOptions& = {});

// The default model of a built-in set ("A"), from simulated raters; nothing for a set
// whose making nobody knows.
std::optional<AdjectiveModel> builtin_adjective_model(const std::string& set,
                                                      const motion::QuantificationOptions& = {});

}  // namespace promenade::study
