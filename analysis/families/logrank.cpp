#include "analysis/statistics/logrank.h"

#include "analysis/families/family.h"

namespace promenade::analysis::families {
namespace {

std::vector<GroupedDuration> durations_in(const Json& input, const Labels& groups) {
  const std::vector<Duration> durations = durations_of(input);
  const std::size_t size = durations.size();
  const std::vector<int> strata =
      input.contains("stratum") ? labels(input, "stratum").places : std::vector<int>(size, 0);
  if (groups.places.size() != size || strata.size() != size) {
    throw CaseError("input.time, input.group and input.stratum differ in length");
  }
  std::vector<GroupedDuration> result;
  for (std::size_t i = 0; i < size; ++i) {
    result.push_back({durations[i], groups.places[i], strata[i]});
  }
  return result;
}

}  // namespace

Json logrank(const Json& input) {
  const Labels groups = labels(input, "group");
  const LogRankTest test = analysis::logrank(durations_in(input, groups), groups.count);
  return {{"observed", test.observed},  {"expected", test.expected},
          {"var", test.variance},       {"df", test.df},
          {"chi2", to_json(test.chi2)}, {"p", to_json(test.p)}};
}

}  // namespace promenade::analysis::families
