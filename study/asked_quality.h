// How much of an asked quality the motions have, by those who rated them: a find task that asks
// for "happy" is scored on the pair "sad-happy".
#pragma once

#include <optional>
#include <string>

#include "study/adjective_model.h"
#include "study/study.h"

namespace promenade::study {

struct AskedPair {
  int pair = 0;       // index into the pairs that were asked about
  bool left = false;  // the asked word is its left pole
};

// Of these pairs, "sad-happy" and so on, the one that the study names for this target (`pair`), in
// either order of its words; else the first that has the target's name, or its English word, as a
// pole. Nothing: none says anything about it.
std::optional<AskedPair> asked_pair(const std::vector<std::string>& pairs, const Target& target);

// N: the mean ratings towards the asked word, -2 to 2; NaN where nobody rated.
Eigen::VectorXd asked_ratings(const AdjectiveModel& model, const AskedPair& asked);

// Of the motions of a study: its own ratings, else those of simulated raters of a built-in set.
std::optional<AdjectiveModel> rated_adjectives(const StudyBundle& bundle);

}  // namespace promenade::study
