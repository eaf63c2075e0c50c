// What the adjective sliders are made of: ratings, quantified ([O] Eqs. 1-6), with a name
// for each primary parameter. Where the ratings come from simulated raters, the model
// says so, and whoever shows it does, too.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "study/rater_agreement.h"
#include "study/texts.h"

namespace promenade::study {

// What a slider is called, in the words of whoever made the model.
struct PrimaryWords {
  LocalText name;       // "en" names it in logs, too
  LocalText low, high;  // at its ends; empty: the words of its most typical pair
};

struct AdjectiveModel {
  RatingsTable table;
  motion::QuantificationOptions options;
  motion::Quantification quantification;
  std::vector<std::string> kept_pairs;  // Q: names of the pairs that are left
  std::vector<std::string> names;       // C: "quickness" and so on
  std::vector<double> name_agreement;   // C: how much each cluster is the printed one, 0 to 1
  std::vector<PrimaryWords> words;      // C; empty: nobody gave names
  std::string source;                   // "ratings.csv", "14 simulated raters, seed 1"

  RaterAgreement agreement;  // without it no sliders are made

  bool simulated() const { return table.simulated; }
};

AdjectiveModel make_adjective_model(RatingsTable table, const std::string& source,
                                    const motion::QuantificationOptions& = {});

// The model with these names; as many as it has clusters. The English ones are its `names`.
AdjectiveModel named(AdjectiveModel model, std::vector<PrimaryWords> words);

// The model with its motions in this order; they are the same ones. Clusters stay as they are,
// also where another order of sums would break ties between pairs otherwise.
AdjectiveModel reordered(AdjectiveModel model, const std::vector<std::string>& motions);

// The names that it has now, in English: to begin with.
std::vector<PrimaryWords> words_of(const AdjectiveModel& model);

// Names of the pairs of a cluster.
std::vector<std::string> pairs_of(const AdjectiveModel& model, int cluster);

// The default model of a built-in set ("A"), from simulated raters; nothing for a set
// whose making nobody knows.
std::optional<AdjectiveModel> builtin_adjective_model(const std::string& set,
                                                      const motion::QuantificationOptions& = {});

// Adjectives of motions that nobody rated, told from their features by ridge regression
// on motions that somebody did ([O] names it as future work).
struct PredictedAdjectives {
  std::vector<std::string> names;  // C, as the model's
  Eigen::MatrixXd primary;         // C x N, 0 to 1
  Eigen::VectorXd left_out_error;  // C: of rated motions when they are left out
  std::string source;              // of the model
  bool simulated = false;
};

// `rated` are the motions of the model. Throws InputError, at the model's source, with
// fewer than three of them or when no pair of adjectives is left.
PredictedAdjectives predict_adjectives(const AdjectiveModel& model, const motion::MotionSet& rated,
                                       const motion::MotionSet& others);

}  // namespace promenade::study
