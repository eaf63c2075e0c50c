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
      return other.kind == UiEvent::Kind::key && other.down == one.down;
  }
  return false;
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
    matching.lost += found - next;
    matching.error_us.push_back(event.t_us - found->t_us);
    matching.uncertainty_us.push_back(event.uncertainty_us);
    next = found + 1;
  }
  matching.lost += injected.end() - next;
  return matching;
}

}  // namespace promenade::app::input
