#include "study/session_length.h"

#include <algorithm>

#include "motion/quantile.h"
#include "study/simulate.h"

namespace promenade::study {
namespace {

// 0 when it never ended.
std::int64_t end_of(const std::vector<Record>& records) {
  const SessionEnded* ended =
      records.empty() ? nullptr : std::get_if<SessionEnded>(&records.back());
  return ended ? ended->t_us : 0;
}

}  // namespace

SessionLength session_length(const StudyBundle& bundle, const InterfaceRegistry& registry,
                             int people, const std::function<bool()>& go_on) {
  std::vector<double> minutes;
  for (int i = 0; i < people && (i == 0 || go_on()); ++i) {
    const std::uint64_t seed =
        Rng(bundle.study.seed, static_cast<std::uint64_t>(i), "length").next();
    const auto records = simulate_session(bundle, registry, make_plan(bundle.study, i), seed);
    minutes.push_back(static_cast<double>(end_of(records)) / 60e6);
  }
  const auto [least, most] = std::minmax_element(minutes.begin(), minutes.end());
  return {motion::quantile(minutes, 0.5), *least, *most};
}

}  // namespace promenade::study
