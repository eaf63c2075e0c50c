#include "analysis/comparisons.h"

#include "analysis/item.h"
#include "analysis/parallel.h"
#include "analysis/statistics/differences.h"
#include "analysis/statistics/p_adjust.h"
#include "analysis/statistics/rank_biserial.h"

namespace promenade::analysis {
namespace {

using Values = PersonValues;

// Values of one interface at one place, in an order that pairs them.
Values values_at(const Dataset& data, const Comparison& place, int interface) {
  if (place.pooling != Pooling::trials) {
    return mean_per_person(data, place.measure, interface, place.task, place.target);
  }
  Values all;
  const Task& task = item(data.tasks, place.task);
  for (std::size_t target = 0; target < task.targets.size(); ++target) {
    const Values more =
        mean_per_person(data, place.measure, interface, place.task, static_cast<int>(target));
    all.insert(all.end(), more.begin(), more.end());
  }
  return all;
}

// Nobody has either value: not missing, just not asked.
int one_sided(const Values& a, const Values& b) {
  int count = 0;
  for (std::size_t i = 0; i < a.size(); ++i) count += a[i].has_value() != b[i].has_value() ? 1 : 0;
  return count;
}

void run_tests(Comparison& comparison, const Values& a, const Values& b) {
  comparison.missing = one_sided(a, b);
  comparison.d = paired_differences(a, b).values;
  const bool pooled = comparison.pooling == Pooling::trials;
  comparison.test = wilcoxon(comparison.d, Zeros::drop, pooled ? pooled_limit : sign_flips_limit);
  if (comparison.d.empty()) return;
  comparison.p = reported_p(comparison.test);
  comparison.rank_biserial_ci = rank_biserial_interval(comparison.test, 0.95);
  const WalshAverages walsh(comparison.d);
  comparison.hl = hodges_lehmann(walsh);
  comparison.hl_ci = hodges_lehmann_interval(walsh, comparison.test.n, 0.95);
}

void adjust(std::vector<Comparison>& family) {
  std::vector<double> p;
  for (const Comparison& comparison : family) {
    if (comparison.p) p.push_back(*comparison.p);
  }
  const std::vector<double> adjusted = adjust_holm(p);
  std::size_t next = 0;
  for (Comparison& comparison : family) {
    comparison.family = size_of(p);
    if (comparison.p) comparison.p_holm = adjusted[next++];
  }
}

std::vector<Comparison> compare_at(const Dataset& data, const Comparison& place) {
  std::vector<Values> values;
  for (int i = 0; i < size_of(data.interfaces); ++i) values.push_back(values_at(data, place, i));
  return compare_pairs(place, values);
}

std::vector<Comparison> places_of(const Dataset& data, int measure, int task) {
  Comparison place;
  place.measure = measure;
  place.task = task;
  place.pooling = Pooling::participants;
  std::vector<Comparison> places = {place};
  if (item(data.measures, measure).kind == MeasureKind::process) return places;
  place.pooling = Pooling::trials;
  places.push_back(place);
  place.pooling = Pooling::none;
  const auto targets = item(data.tasks, task).targets.size();
  for (std::size_t target = 0; target < targets; ++target) {
    place.target = static_cast<int>(target);
    places.push_back(place);
  }
  return places;
}

}  // namespace

std::vector<Comparison> compare_pairs(const Comparison& place,
                                      const std::vector<PersonValues>& values) {
  std::vector<Comparison> family;
  for (int a = 0; a < size_of(values); ++a) {
    for (int b = a + 1; b < size_of(values); ++b) {
      Comparison comparison = place;
      comparison.a = a;
      comparison.b = b;
      run_tests(comparison, item(values, a), item(values, b));
      family.push_back(std::move(comparison));
    }
  }
  adjust(family);
  return family;
}

std::optional<double> reported_p(const SignedRankTest& test) {
  if (test.n == 0) return std::nullopt;
  return test.exact ? test.exact->two : test.normal->two;
}

std::vector<Comparison> compare_participants(const Dataset& data, int measure, int task) {
  Comparison place;
  place.measure = measure;
  place.task = task;
  place.pooling = Pooling::participants;
  return compare_at(data, place);
}

std::vector<Comparison> compare_all(const Dataset& data, const Progress& progress) {
  std::vector<Comparison> places;
  for (int task = 0; task < size_of(data.tasks); ++task) {
    for (int measure = 0; measure < size_of(data.measures); ++measure) {
      if (!data.occurs(measure, task)) continue;
      const std::vector<Comparison> more = places_of(data, measure, task);
      places.insert(places.end(), more.begin(), more.end());
    }
  }
  std::vector<std::vector<Comparison>> families(places.size());
  for_each_index(
      size_of(places), [&](int i) { item(families, i) = compare_at(data, item(places, i)); },
      progress, "comparisons made:");
  std::vector<Comparison> all;
  for (std::vector<Comparison>& family : families) {
    std::move(family.begin(), family.end(), std::back_inserter(all));
  }
  return all;
}

}  // namespace promenade::analysis
