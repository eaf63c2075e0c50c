#include "analysis/ratings/stimulus_ratings.h"

#include <cmath>
#include <map>
#include <utility>

#include "analysis/item.h"

namespace promenade::analysis {
namespace {

struct Sum {
  double sum = 0;
  int count = 0;
  double mean() const { return sum / count; }
};

StimulusRating described(const std::map<int, Sum>& raters) {
  StimulusRating one;
  one.raters = static_cast<int>(raters.size());
  for (const auto& [rater, sum] : raters) one.mean += sum.mean() / one.raters;
  if (one.raters < 2) return one;
  double squares = 0;
  for (const auto& [rater, sum] : raters) squares += std::pow(sum.mean() - one.mean, 2);
  one.deviation = std::sqrt(squares / (one.raters - 1));
  return one;
}

}  // namespace

std::vector<StimulusRating> stimulus_ratings(const std::vector<study::NamedRating>& ratings) {
  const study::RatingsTable table = study::make_ratings_table(ratings, {});
  std::map<std::pair<int, int>, std::map<int, Sum>> sums;  // by motion and pair, then by rater
  for (const motion::Rating& rating : table.ratings) {
    Sum& sum = sums[{rating.motion, rating.pair}][rating.rater];
    sum.sum += rating.value;
    ++sum.count;
  }
  std::vector<StimulusRating> result;
  for (const auto& [key, raters] : sums) {
    result.push_back(described(raters));
    result.back().stimulus = item(table.motions, key.first);
    result.back().pair = item(table.pairs, key.second);
  }
  return result;
}

}  // namespace promenade::analysis
