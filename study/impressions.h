// How the walks of a set seem on the 41 pairs of adjectives to those who are not people:
// simulated raters and simulated participants (docs/methods.md, 8). Of a built-in set by how
// each walk was meant, of any other by its features.
#pragma once

#include <mutex>
#include <optional>
#include <string_view>

#include "motion/motion_set.h"
#include "motion/style_character.h"
#include "study/instrument.h"

namespace promenade::study {

// 41: how a walk seems on each pair, in steps of the scale and without its ends: linear in how
// the walk was meant, so that the impression of a mixture is that of its parts, by their weights.
Eigen::VectorXd felt_of(const motion::StyleCharacter& walk);
// What of it goes onto the scale from -2 to 2, never quite to its ends: nobody is sure of an
// extreme.
double judged(double felt);
// How much two people differ about a pair, standard deviation in steps of the scale.
double doubt_about(int pair);

// 41 x N: felt_of each walk. `builtin`: the name of the built-in set ("A") that it may be. Of any
// other set they are told from its features by ridge regression on the walks of `builtin:B` and
// `builtin:N`.
Eigen::MatrixXd impressions_of(const motion::MotionSet& set, std::string_view builtin);

// The same of one set, worked out when somebody first asks: only simulated people do. Any thread
// may.
class Impressions {
 public:
  const Eigen::MatrixXd& of(const motion::MotionSet& set, std::string_view builtin) const;

 private:
  mutable std::once_flag once_;
  mutable Eigen::MatrixXd felt_;
};

// The pair that an item asks for: one of the 41, or one of the short form's four names
// ("quickness" and so on); -1: something else.
int pair_asked_by(const Item& item);
// Does some item of it ask for a pair?
bool asks_for_pairs(const Instrument& instrument);

}  // namespace promenade::study
