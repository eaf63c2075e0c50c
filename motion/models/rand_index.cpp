#include "motion/models/rand_index.h"

#include <algorithm>
#include <cassert>
#include <map>
#include <utility>

namespace promenade::motion {
namespace {

double pairs_of(double items) { return items * (items - 1) / 2; }

// Pairs of items that share a cluster, by the counts of the clusters.
template <typename Key>
double pairs_within(const std::map<Key, int>& counts) {
  double sum = 0;
  for (const auto& [key, count] : counts) sum += pairs_of(count);
  return sum;
}

}  // namespace

double adjusted_rand_index(const std::vector<int>& a, const std::vector<int>& b) {
  assert(a.size() == b.size() && "labels of the same items");
  std::map<int, int> in_a, in_b;
  std::map<std::pair<int, int>, int> in_both;
  for (std::size_t i = 0; i < a.size(); ++i) {
    ++in_a[a[i]];
    ++in_b[b[i]];
    ++in_both[{a[i], b[i]}];
  }
  const double all = pairs_of(static_cast<double>(a.size()));
  if (all == 0) return 1;
  const double of_a = pairs_within(in_a);
  const double of_b = pairs_within(in_b);
  const double expected = of_a * of_b / all;
  const double most = (of_a + of_b) / 2;
  if (most == expected) return 1;
  return (pairs_within(in_both) - expected) / (most - expected);
}

PrintedComparison compare_with_printed(const std::vector<int>& cluster,
                                       const PrintedClusters& printed) {
  assert(cluster.size() == printed.size() && "printed clusters of the same items");
  PrintedComparison result;
  std::map<std::string_view, int> numbers;
  std::vector<int> ours, theirs;
  for (std::size_t i = 0; i < cluster.size(); ++i) {
    if (printed[i].empty()) {
      result.missing.push_back(static_cast<int>(i));
      continue;
    }
    result.items.push_back(static_cast<int>(i));
    ours.push_back(cluster[i]);
    theirs.push_back(numbers.emplace(printed[i], static_cast<int>(numbers.size())).first->second);
  }
  result.rand_index = adjusted_rand_index(ours, theirs);
  return result;
}

}  // namespace promenade::motion
