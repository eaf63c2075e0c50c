#include "study/impressions.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "motion/builtin.h"
#include "motion/models/adjective_pairs.h"
#include "motion/models/features.h"
#include "motion/models/ridge.h"

namespace promenade::study {
namespace {

using motion::StyleCharacter;

// What a pair of adjectives has to do with how a walk was meant: the weights of its
// qualities, ours; and how much two people differ about it, in steps of the scale. Pairs
// that walks hardly show ([O] dropped them for both of its sets) are guesswork.
struct Reading {
  std::string_view pair;
  StyleCharacter weights;
  double doubt = 0;
};

constexpr auto readings = std::to_array<Reading>({
    {"slow-fast", {.pace = 1.8}, 0.5},
    {"mild-violent", {.valence = 0.1, .arousal = 1.1, .tension = 0.4}, 0.5},
    {"hard-soft", {.weight = -0.3, .tension = -0.6}, 1.2},
    {"dull-quick", {.arousal = 0.1, .pace = 1.7}, 0.5},
    {"quiet-noisy", {.valence = 0.2, .arousal = 1.1, .weight = 0.3}, 0.5},
    {"angular-circular", {.tension = -0.3, .naturalness = 0.2}, 1.2},
    {"blunt-sharp", {.arousal = 0.3, .pace = 1.2}, 0.5},
    {"dormant-brisk", {.valence = 0.4, .arousal = 1.1}, 0.5},
    {"edgy-round", {.tension = -0.4}, 1.1},
    {"weak-strong", {.openness = 0.2, .steadiness = 1.2}, 0.5},
    {"unpleasant-pleasant", {.valence = 1.2, .arousal = 0.3}, 0.5},
    {"inelastic-elastic", {.weight = -0.4, .youth = 0.2}, 1.2},
    {"dirty-clean", {.valence = 0.3, .steadiness = 1.1}, 0.5},
    {"sad-happy", {.valence = 1.1, .arousal = 0.6}, 0.5},
    {"bumpy-smooth", {.steadiness = 1, .tension = -0.3}, 0.5},
    {"uncool-cool", {.openness = 0.2, .steadiness = 1.3}, 0.5},
    {"dark-bright", {.valence = 1, .arousal = 0.6}, 0.5},
    {"thin-thick", {.weight = 0.4}, 1.2},
    {"ugly-cute", {.valence = 0.3, .steadiness = 1, .youth = 0.2}, 0.5},
    {"simple-gaudy", {.valence = 0.6, .arousal = 0.8, .naturalness = -0.2}, 0.5},
    {"coarse-fine", {.steadiness = 0.3}, 1.2},
    {"old-young", {.valence = 0.2, .steadiness = 0.7, .youth = 0.7}, 0.5},
    {"heavy-light", {.valence = 0.2, .openness = 0.6, .weight = -0.6}, 0.5},
    {"strained-relaxed", {.tension = -0.8}, 1.3},
    {"unstable-stable", {.steadiness = 1.6}, 0.5},
    {"small-large", {.openness = 1.5}, 0.5},
    {"unafraid-afraid", {.valence = -0.3}, 1.2},
    {"artificial-natural", {.valence = 0.2, .steadiness = 0.8, .naturalness = 0.7}, 0.5},
    {"closed-open", {.valence = 0.3, .openness = 1.3}, 0.5},
    {"adult-childish", {.arousal = 0.4, .openness = 0.2, .youth = 0.9}, 0.5},
    {"vague-distinct", {.steadiness = 1.2, .tension = 0.2}, 0.5},
    {"narrow-broad", {.openness = 1.4}, 0.5},
    {"ugly-beautiful", {.valence = 0.3, .steadiness = 1.1}, 0.5},
    {"poor-rich", {.openness = 0.6, .steadiness = 0.8}, 0.5},
    {"tight-free", {.openness = 1.2, .tension = -0.2}, 0.5},
    {"dim-sharp", {.valence = 0.7, .arousal = 0.6, .steadiness = 0.3}, 0.5},
    {"drab-clear", {.valence = 0.2, .steadiness = 1.2}, 0.5},
    {"gloomy-cheerful", {.valence = 0.7, .arousal = 0.5, .openness = 0.7}, 0.5},
    {"lonely-bustling", {.valence = 0.8, .arousal = 0.8}, 0.5},
    {"calm-excited", {.valence = 0.4, .arousal = 1.2}, 0.5},
    {"narrow-wide", {.openness = 1.4}, 0.5},
});

constexpr bool has_the_pairs_of_the_source() {
  for (std::size_t i = 0; i < readings.size(); ++i) {
    const motion::AdjectivePair& pair = motion::adjective_pairs[i];
    const std::string_view name = readings[i].pair;
    const bool same = name.starts_with(pair.left) && name.ends_with(pair.right) &&
                      name.size() == pair.left.size() + 1 + pair.right.size();
    if (!same) return false;
  }
  return readings.size() == motion::adjective_pairs.size();
}
static_assert(has_the_pairs_of_the_source(), "in their order");

constexpr double emphasis = 2;  // from a weighted quality to steps of the scale
constexpr double most = 2;      // the scale is -2 to 2

double felt(const Reading& reading, const StyleCharacter& walk) {
  const StyleCharacter& weight = reading.weights;
  const double sum = weight.valence * walk.valence + weight.arousal * walk.arousal +
                     weight.pace * walk.pace + weight.openness * walk.openness +
                     weight.weight * walk.weight + weight.steadiness * walk.steadiness +
                     weight.tension * walk.tension + weight.youth * walk.youth +
                     weight.naturalness * walk.naturalness;
  return emphasis * sum;
}

// 41 x N of a built-in set.
Eigen::MatrixXd meant(std::string_view builtin) {
  const std::vector<StyleCharacter> walks = motion::builtin_characters(builtin);
  Eigen::MatrixXd felt(static_cast<Eigen::Index>(readings.size()),
                       static_cast<Eigen::Index>(walks.size()));
  for (std::size_t i = 0; i < walks.size(); ++i) {
    felt.col(static_cast<Eigen::Index>(i)) = felt_of(walks[i]);
  }
  return felt;
}

// Emotions at three speeds and styles in three families: of either alone hardly anything follows
// for the walks of the other.
motion::Ridge learned() {
  Eigen::MatrixXd features(motion::feature_count, 0);
  Eigen::MatrixXd felt(static_cast<Eigen::Index>(readings.size()), 0);
  for (const char* name : {"B", "N"}) {
    const Eigen::MatrixXd more = motion::motion_features(*motion::builtin_set(name));
    features.conservativeResize(Eigen::NoChange, features.cols() + more.cols());
    features.rightCols(more.cols()) = more;
    felt.conservativeResize(Eigen::NoChange, features.cols());
    felt.rightCols(more.cols()) = meant(name);
  }
  return motion::fit_ridge(features, felt);
}

// What a pair adds up to cannot go on for ever where features lie outside those it was learned
// from.
constexpr double furthest = 4;

Eigen::MatrixXd predicted(const motion::MotionSet& set) {
  static const motion::Ridge ridge = learned();
  Eigen::MatrixXd felt =
      Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(readings.size()), set.size());
  if (set.key_phases.size() < 2) return felt;  // no step to measure
  const Eigen::MatrixXd features = motion::motion_features(set);
  for (Eigen::Index i = 0; i < features.cols(); ++i) {
    const Eigen::VectorXd told = motion::predict(ridge, features.col(i));
    if (told.allFinite()) felt.col(i) = told.cwiseMax(-furthest).cwiseMin(furthest);
  }
  return felt;
}

struct ShortForm {
  std::string_view item, pair;
};
// configs/instruments/impression.toml asks for the four primary parameters by these.
constexpr auto short_form = std::to_array<ShortForm>({{"quickness", "slow-fast"},
                                                      {"clearness", "drab-clear"},
                                                      {"activeness", "calm-excited"},
                                                      {"largeness", "small-large"}});

}  // namespace

Eigen::VectorXd felt_of(const StyleCharacter& walk) {
  Eigen::VectorXd all(static_cast<Eigen::Index>(readings.size()));
  for (std::size_t pair = 0; pair < readings.size(); ++pair) {
    all(static_cast<Eigen::Index>(pair)) = felt(readings[pair], walk);
  }
  return all;
}

double judged(double felt) { return most * std::tanh(felt / most); }

double doubt_about(int pair) { return readings[static_cast<std::size_t>(pair)].doubt; }

Eigen::MatrixXd impressions_of(const motion::MotionSet& set, std::string_view builtin) {
  const bool known = motion::names_of(set) == motion::builtin_names(builtin);
  return known ? meant(builtin) : predicted(set);
}

const Eigen::MatrixXd& Impressions::of(const motion::MotionSet& set,
                                       std::string_view builtin) const {
  std::call_once(once_, [&] { felt_ = impressions_of(set, builtin); });
  return felt_;
}

int pair_asked_by(const Item& item) {
  if (item.kind != ItemKind::scale) return -1;
  const auto found = std::find_if(short_form.begin(), short_form.end(),
                                  [&](const ShortForm& one) { return one.item == item.name; });
  return motion::find_adjective_pair(found == short_form.end() ? item.name : found->pair);
}

bool asks_for_pairs(const Instrument& instrument) {
  return std::any_of(instrument.items.begin(), instrument.items.end(),
                     [](const Item& item) { return pair_asked_by(item) >= 0; });
}

}  // namespace promenade::study
