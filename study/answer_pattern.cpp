#include "study/answer_pattern.h"

#include <algorithm>
#include <set>

#include "motion/quantile.h"

namespace promenade::study {
namespace {

int longest_run(const std::vector<TimedAnswer>& answers) {
  int longest = 0;
  int run = 0;
  for (std::size_t i = 0; i < answers.size(); ++i) {
    run = i > 0 && answers[i].value == answers[i - 1].value ? run + 1 : 1;
    longest = std::max(longest, run);
  }
  return longest;
}

int distinct(const std::vector<TimedAnswer>& answers) {
  std::set<double> values;
  for (const TimedAnswer& one : answers) values.insert(one.value);
  return static_cast<int>(values.size());
}

// In whatever order they were given.
std::optional<double> median_step(const std::vector<TimedAnswer>& answers) {
  if (answers.size() < 2) return std::nullopt;
  std::vector<std::int64_t> times;
  for (const TimedAnswer& one : answers) times.push_back(one.t_us);
  std::sort(times.begin(), times.end());
  std::vector<double> steps;
  for (std::size_t i = 1; i < times.size(); ++i) {
    steps.push_back(1e-6 * static_cast<double>(times[i] - times[i - 1]));
  }
  return motion::quantile(std::move(steps), 0.5);
}

}  // namespace

AnswerPattern answer_pattern(const std::vector<TimedAnswer>& answers) {
  AnswerPattern pattern;
  pattern.items = static_cast<int>(answers.size());
  pattern.longest_run = longest_run(answers);
  pattern.distinct = distinct(answers);
  pattern.median_s = median_step(answers);
  pattern.straight = pattern.items >= least_items_to_vary &&
                     pattern.longest_run >= straight_run_share * pattern.items;
  pattern.fast =
      pattern.items >= least_items_to_time && pattern.median_s && *pattern.median_s < fastest_s;
  return pattern;
}

}  // namespace promenade::study
