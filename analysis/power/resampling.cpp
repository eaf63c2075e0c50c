#include "analysis/power/resampling.h"

#include <algorithm>

#include "analysis/comparisons.h"
#include "analysis/format.h"
#include "analysis/item.h"
#include "analysis/parallel.h"
#include "analysis/statistics/differences.h"
#include "analysis/statistics/p_adjust.h"
#include "motion/problem.h"
#include "study/rng.h"

namespace promenade::analysis {
namespace {

using Values = std::vector<std::optional<double>>;

// A pair of interfaces, and for each person of the pilot the difference, centred.
struct PilotPair {
  std::string a, b;
  Values d;
  double effect = 0;  // of a - b, when this pair is in question
};

int index_or_throw(const std::vector<std::string>& all, const std::string& name,
                   const std::string& file, const std::string& what) {
  const auto found = std::find(all.begin(), all.end(), name);
  if (found != all.end()) return static_cast<int>(found - all.begin());
  throw InputError(file, "has no " + what + " \"" + name + "\"; it has " + listed(all));
}

std::vector<std::string> tasks_of(const Dataset& data) {
  std::vector<std::string> all;
  for (const Task& task : data.tasks) all.push_back(task.name);
  return all;
}

std::vector<std::string> measures_in(const Dataset& data, int task) {
  std::vector<std::string> all;
  for (int i = 0; i < size_of(data.measures); ++i) {
    if (data.occurs(i, task)) all.push_back(item(data.measures, i).name);
  }
  return all;
}

// Nothing where fewer than two people have both.
std::optional<PilotPair> pair_of(const Values& a, const Values& b) {
  PilotPair pair;
  const std::vector<double> d = paired_differences(a, b).values;
  if (d.size() < 2) return std::nullopt;
  const double centre = *hodges_lehmann(WalshAverages(d));
  std::size_t next = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    const bool both = a[i] && b[i];
    pair.d.push_back(both ? std::optional(d[next++] - centre) : std::nullopt);
  }
  return pair;
}

std::vector<PilotPair> pairs_of(const Dataset& pilot, int measure, int task,
                                const SmallestEffect& effect) {
  std::vector<Values> values;
  for (int i = 0; i < size_of(pilot.interfaces); ++i) {
    values.push_back(mean_per_person(pilot, measure, i, task));
  }
  std::vector<PilotPair> pairs;
  for (int a = 0; a < size_of(values); ++a) {
    for (int b = a + 1; b < size_of(values); ++b) {
      auto pair = pair_of(item(values, a), item(values, b));
      if (!pair) continue;
      pair->a = item(pilot.interfaces, a);
      pair->b = item(pilot.interfaces, b);
      pair->effect = pair->a == effect.b ? -effect.effect : effect.effect;
      pairs.push_back(std::move(*pair));
    }
  }
  return pairs;
}

// The differences of these people, shifted; magnitudes that differ by rounding alone are ties.
std::vector<double> drawn_differences(const PilotPair& pair, const std::vector<int>& people,
                                      double shift) {
  Values d, zero;
  for (const int person : people) {
    const std::optional<double>& value = item(pair.d, person);
    if (value) d.push_back(*value + shift);
  }
  zero.assign(d.size(), 0.0);
  return paired_differences(d, zero).values;
}

// In the order of the pairs: each with the effect while no other has one.
std::vector<PairFinding> test_pairs(const std::vector<PilotPair>& pairs,
                                    const std::vector<int>& people) {
  std::vector<std::optional<double>> without;
  for (const PilotPair& pair : pairs) {
    if (pairs.size() == 1) break;  // no family
    without.push_back(reported_p(wilcoxon(drawn_differences(pair, people, 0))));
  }
  std::vector<PairFinding> findings;
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    PairFinding finding;
    const std::vector<double> d = drawn_differences(pairs[i], people, pairs[i].effect);
    finding.p = reported_p(wilcoxon(d));
    finding.hl = hodges_lehmann(WalshAverages(d));
    if (finding.p) {
      std::vector<double> family = {*finding.p};
      for (std::size_t j = 0; j < without.size(); ++j) {
        if (j != i && without[j]) family.push_back(*without[j]);
      }
      finding.p_holm = adjust_holm(family).front();
    }
    findings.push_back(finding);
  }
  return findings;
}

// findings[study][pair] of so many participants.
std::vector<std::vector<PairFinding>> draw_studies(const std::vector<PilotPair>& pairs,
                                                   int participants,
                                                   const PowerQuestion& question) {
  const auto pilot = item(pairs, 0).d.size();
  std::vector<std::vector<PairFinding>> findings(static_cast<std::size_t>(question.studies));
  for_each_index(
      question.studies,
      [&](int study) {
        study::Rng rng(question.seed, static_cast<std::uint64_t>(study), "resampling");
        std::vector<int> people;
        for (int i = 0; i < participants; ++i) people.push_back(static_cast<int>(rng.below(pilot)));
        item(findings, study) = test_pairs(pairs, people);
      },
      question.progress,
      "studies of " + std::to_string(participants) + " drawn:", question.threads);
  return findings;
}

bool asked(const SmallestEffect& effect, const PilotPair& pair) {
  return effect.a.empty() || (pair.a == effect.a && pair.b == effect.b) ||
         (pair.a == effect.b && pair.b == effect.a);
}

std::vector<PowerRow> rows_of(const std::vector<PilotPair>& pairs, const SmallestEffect& effect,
                              const PowerQuestion& question) {
  std::vector<PowerRow> rows;
  for (const int participants : question.participants) {
    const auto findings = draw_studies(pairs, participants, question);
    for (std::size_t i = 0; i < pairs.size(); ++i) {
      if (!asked(effect, pairs[i])) continue;
      std::vector<PairFinding> of_pair;
      for (const auto& study : findings) of_pair.push_back(study[i]);
      PowerRow row = power_row(of_pair, question.alpha);
      row.a = pairs[i].a;
      row.b = pairs[i].b;
      row.participants = participants;
      std::vector<double> drawn_from;
      for (const auto& d : pairs[i].d) {
        if (d) drawn_from.push_back(*d + pairs[i].effect);
      }
      add_formulas(row, drawn_from, question.alpha);
      rows.push_back(std::move(row));
    }
  }
  return rows;
}

}  // namespace

PowerTable resampled_power(const Dataset& pilot, const std::string& file,
                           const SmallestEffect& effect, const PowerQuestion& question) {
  const int task = index_or_throw(tasks_of(pilot), effect.task, file, "task");
  index_or_throw(measures_in(pilot, task), effect.measure, file,
                 "measure in task " + effect.task + " called");
  for (const std::string& name : {effect.a, effect.b}) {
    if (!name.empty()) index_or_throw(pilot.interfaces, name, file, "interface");
  }
  const int measure = pilot.measure(effect.measure);
  const std::vector<PilotPair> pairs = pairs_of(pilot, measure, task, effect);
  const bool any = std::any_of(pairs.begin(), pairs.end(),
                               [&](const PilotPair& pair) { return asked(effect, pair); });
  if (!any) {
    throw InputError(file, "has no two people who count with a value of both interfaces");
  }
  PowerTable table{
      effect.task, item(pilot.measures, measure), rows_of(pairs, effect, question), {}};
  std::stable_sort(table.rows.begin(), table.rows.end(), [&](const auto& x, const auto& y) {
    const auto place = [&](const PowerRow& row) {
      return std::find_if(
                 pairs.begin(), pairs.end(),
                 [&row](const PilotPair& pair) { return pair.a == row.a && pair.b == row.b; }) -
             pairs.begin();
    };
    return place(x) < place(y);
  });
  return table;
}

}  // namespace promenade::analysis
