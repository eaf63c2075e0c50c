#include "study/simulated_raters.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "motion/builtin.h"
#include "motion/models/adjective_pairs.h"
#include "study/impressions.h"
#include "study/ratings_csv.h"
#include "study/rng.h"

namespace promenade::study {
namespace {

constexpr double most = 2;  // the scale is -2 to 2
constexpr int pairs = static_cast<int>(motion::adjective_pairs.size());

// One rater's value of every walk on every pair.
void rate(const std::vector<Eigen::VectorXd>& walks, const RaterOptions& options, int rater,
          std::vector<motion::Rating>& ratings) {
  Rng rng(options.seed, static_cast<std::uint64_t>(rater), "rater");
  const double bold = std::exp(options.boldness * rng.normal());
  for (int pair = 0; pair < pairs; ++pair) {
    const double leaning = options.leaning * rng.normal();
    for (std::size_t walk = 0; walk < walks.size(); ++walk) {
      const double felt =
          bold * judged(walks[walk](pair)) + leaning + doubt_about(pair) * rng.normal();
      ratings.push_back(
          {rater, pair, static_cast<int>(walk), std::clamp(std::round(felt), -most, most)});
    }
  }
}

}  // namespace

std::optional<RatingsTable> simulated_ratings(const std::string& set, const RaterOptions& options) {
  std::vector<Eigen::VectorXd> walks;
  for (const auto& one : motion::builtin_characters(set)) walks.push_back(felt_of(one));
  if (walks.empty()) return std::nullopt;
  RatingsTable table;
  table.motions = motion::builtin_names(set);
  for (const motion::AdjectivePair& pair : motion::adjective_pairs) {
    table.pairs.push_back(motion::pair_name(pair));
  }
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
