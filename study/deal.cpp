#include "study/deal.h"

#include <algorithm>
#include <cassert>

namespace promenade::study {

std::vector<std::vector<int>> deal_lists(const std::vector<double>& difficulties, int lists) {
  const int n = static_cast<int>(difficulties.size());
  assert(lists > 0 && n % lists == 0 && "every list gets equally many");
  std::vector<int> sorted;
  for (int i = 0; i < n; ++i) sorted.push_back(i);
  std::stable_sort(sorted.begin(), sorted.end(), [&](int a, int b) {
    return difficulties[static_cast<std::size_t>(a)] < difficulties[static_cast<std::size_t>(b)];
  });
  std::vector<std::vector<int>> dealt(static_cast<std::size_t>(lists));
  for (int i = 0; i < n; ++i) {
    const bool back = i / lists % 2 == 1;
    const int list = back ? lists - 1 - i % lists : i % lists;
    dealt[static_cast<std::size_t>(list)].push_back(sorted[static_cast<std::size_t>(i)]);
  }
  return dealt;
}

}  // namespace promenade::study
