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

// Adds the minutes from each page that was opened to the end.
void add_minutes_left(const std::vector<Record>& records,
                      std::vector<std::vector<double>>& by_page) {
  const std::int64_t end_us = end_of(records);
  for (const Record& record : records) {
    const Event* event = std::get_if<Event>(&record);
    if (event == nullptr || event->kind != "page" || !event->value) continue;
    const auto page = static_cast<std::size_t>(*event->value);
    by_page[page].push_back(static_cast<double>(end_us - event->t_us) / 60e6);
  }
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

std::vector<double> minutes_left(const StudyBundle& bundle, const InterfaceRegistry& registry,
                                 const Plan& plan, int people) {
  std::vector<std::vector<double>> by_page(plan.pages.size());
  for (int i = 0; i < people; ++i) {
    const std::uint64_t seed =
        Rng(bundle.study.seed, static_cast<std::uint64_t>(i), "length").next();
    add_minutes_left(simulate_session(bundle, registry, plan, seed), by_page);
  }
  std::vector<double> left(by_page.size(), 0);
  for (std::size_t page = left.size(); page-- > 0;) {
    const double next = page + 1 < left.size() ? left[page + 1] : 0;
    left[page] = by_page[page].empty() ? next : motion::quantile(by_page[page], 0.5);
  }
  return left;
}

}  // namespace promenade::study
