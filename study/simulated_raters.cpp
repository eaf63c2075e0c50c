#include "study/simulated_raters.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "motion/builtin.h"
#include "motion/models/adjective_pairs.h"
#include "study/ratings_csv.h"
#include "study/rng.h"

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

constexpr double emphasis = 2;  // from a weighted quality to steps of the scale
constexpr double most = 2;      // the scale is -2 to 2

// -2 to 2, never quite at the ends: nobody is sure of an extreme.
double impression(const Reading& reading, const StyleCharacter& walk) {
  const StyleCharacter& weight = reading.weights;
  const double sum = weight.valence * walk.valence + weight.arousal * walk.arousal +
                     weight.pace * walk.pace + weight.openness * walk.openness +
                     weight.weight * walk.weight + weight.steadiness * walk.steadiness +
                     weight.tension * walk.tension + weight.youth * walk.youth +
                     weight.naturalness * walk.naturalness;
  return most * std::tanh(emphasis * sum / most);
}

// One rater's value of every walk on every pair.
void rate(const std::vector<StyleCharacter>& walks, const RaterOptions& options, int rater,
          std::vector<motion::Rating>& ratings) {
  Rng rng(options.seed, static_cast<std::uint64_t>(rater), "rater");
  const double bold = std::exp(options.boldness * rng.normal());
  for (std::size_t pair = 0; pair < readings.size(); ++pair) {
    const double leaning = options.leaning * rng.normal();
    for (std::size_t walk = 0; walk < walks.size(); ++walk) {
      const double felt = bold * impression(readings[pair], walks[walk]) + leaning +
                          readings[pair].doubt * rng.normal();
      ratings.push_back({rater, static_cast<int>(pair), static_cast<int>(walk),
                         std::clamp(std::round(felt), -most, most)});
    }
  }
}

}  // namespace

std::optional<RatingsTable> simulated_ratings(const std::string& set, const RaterOptions& options) {
  static_assert(readings.size() == motion::adjective_pairs.size());
  const std::vector<StyleCharacter> walks = motion::builtin_characters(set);
  if (walks.empty()) return std::nullopt;
  RatingsTable table;
  table.motions = motion::builtin_names(set);
  for (const Reading& reading : readings) table.pairs.emplace_back(reading.pair);
  table.raters = options.raters;
  table.simulated = true;
  for (int rater = 0; rater < options.raters; ++rater) {
    table.rater_names.push_back(rater_name(rater, true));
    rate(walks, options, rater, table.ratings);
  }
  return table;
}

std::string describe(const RaterOptions& options) {
  return fmt::format("{} simulated raters, seed {}", options.raters, options.seed);
}

}  // namespace promenade::study
