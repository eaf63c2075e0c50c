#include "study/ratings.h"

#include <algorithm>
#include <map>
#include <set>

#include "motion/models/adjective_pairs.h"

namespace promenade::study {
namespace {

using Numbers = std::map<std::string, int>;

int number_of(Numbers& known, const std::string& name) {
  return known.emplace(name, static_cast<int>(known.size())).first->second;
}

Numbers numbered(const std::vector<std::string>& names) {
  Numbers numbers;
  for (const std::string& name : names) number_of(numbers, name);
  return numbers;
}

// Where the source prints a pair; behind the last one for a pair of one's own.
int printed_place(const std::string& pair) {
  const int found = motion::find_adjective_pair(pair);
  return found < 0 ? static_cast<int>(motion::adjective_pairs.size()) : found;
}

}  // namespace

RatingsTable make_ratings_table(const std::vector<NamedRating>& ratings,
                                const std::vector<std::string>& motions) {
  std::set<std::string> pairs, rated;
  for (const NamedRating& rating : ratings) {
    pairs.insert(rating.pair);
    rated.insert(rating.motion);
  }
  RatingsTable table;
  table.pairs.assign(pairs.begin(), pairs.end());
  std::stable_sort(table.pairs.begin(), table.pairs.end(),
                   [](const std::string& a, const std::string& b) {
                     return printed_place(a) < printed_place(b);
                   });
  table.motions = motions;
  if (motions.empty()) table.motions.assign(rated.begin(), rated.end());
  Numbers raters;
  const Numbers pair_numbers = numbered(table.pairs);
  const Numbers motion_numbers = numbered(table.motions);
  for (const NamedRating& rating : ratings) {
    table.ratings.push_back({number_of(raters, rating.rater), pair_numbers.at(rating.pair),
                             motion_numbers.at(rating.motion), rating.value});
  }
  table.raters = static_cast<int>(raters.size());
  table.rater_names.resize(raters.size());
  for (const auto& [name, number] : raters)
    table.rater_names[static_cast<std::size_t>(number)] = name;
  return table;
}

}  // namespace promenade::study
