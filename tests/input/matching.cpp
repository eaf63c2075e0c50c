#include "tests/input/matching.h"

#include <algorithm>

namespace promenade::app::input {
namespace {

bool same(const Injected& one, const UiEvent& other) {
  switch (one.kind) {
    case Injected::Kind::move:
      return other.kind == UiEvent::Kind::move && other.x == one.x && other.y == one.y;
    case Injected::Kind::button:
      return other.kind == UiEvent::Kind::button && other.down == one.down;
    case Injected::Kind::key:
      return other.kind == UiEvent::Kind::key && other.down == one.down && other.code == one.code;
  }
  return false;
}

using Iterator = std::vector<Injected>::const_iterator;

void count_lost(Iterator first, Iterator end, Matching& matching) {
  for (; first != end; ++first) ++matching.lost_of_kind[static_cast<std::size_t>(first->kind)];
}

}  // namespace

std::int64_t Matching::within(std::int64_t slack_us) const {
  std::int64_t count = 0;
  for (std::size_t k = 0; k < error_us.size(); ++k) {
    if (error_us[k] >= 0 && error_us[k] <= uncertainty_us[k] + slack_us) ++count;
  }
  return count;
}

Matching match(const std::vector<Injected>& injected, const std::vector<UiEvent>& arrived) {
  Matching matching;
  auto next = injected.begin();
  for (const UiEvent& event : arrived) {
    const auto found =
        std::find_if(next, injected.end(), [&](const Injected& one) { return same(one, event); });
    if (found == injected.end()) {
      ++matching.foreign;
      continue;
    }
    count_lost(next, found, matching);
    matching.error_us.push_back(event.t_us - found->t_us);
    matching.uncertainty_us.push_back(event.uncertainty_us);
    next = found + 1;
  }
  count_lost(next, injected.end(), matching);
  return matching;
}

}  // namespace promenade::app::input
