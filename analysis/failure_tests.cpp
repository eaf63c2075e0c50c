#include "analysis/failure_tests.h"

#include <algorithm>

#include "analysis/item.h"
#include "analysis/statistics/p_adjust.h"

namespace promenade::analysis {
namespace {

using Failed = std::vector<std::optional<bool>>;  // one per person

PersonValues shares_of(const Dataset& data, int task, int interface) {
  std::vector<int> failed(data.people.size(), 0), trials(data.people.size(), 0);
  for (const Trial& trial : data.trials) {
    if (trial.task != task || trial.interface != interface) continue;
    item(failed, trial.person) += trial.failed ? 1 : 0;
    ++item(trials, trial.person);
  }
  PersonValues shares(data.people.size());
  for (std::size_t i = 0; i < shares.size(); ++i) {
    if (trials[i] > 0) shares[i] = static_cast<double>(failed[i]) / trials[i];
  }
  return shares;
}

std::vector<Comparison> compare_shares(const Dataset& data, int task) {
  Comparison place;
  place.measure = -1;
  place.task = task;
  place.pooling = Pooling::participants;
  std::vector<PersonValues> shares;
  for (int i = 0; i < size_of(data.interfaces); ++i) shares.push_back(shares_of(data, task, i));
  return compare_pairs(place, shares);
}

// Trials stand in the order of the session.
Failed failed_at(const Dataset& data, int task, int target, int interface) {
  Failed failed(data.people.size());
  for (const Trial& trial : data.trials) {
    if (trial.task != task || trial.target != target || trial.interface != interface) continue;
    if (!item(failed, trial.person)) item(failed, trial.person) = trial.failed;
  }
  return failed;
}

FailurePair pair_of(FailurePair place, const Failed& a, const Failed& b) {
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (!a[i] || !b[i]) continue;
    if (*a[i]) {
      ++(*b[i] ? place.both : place.only_a);
    } else {
      ++(*b[i] ? place.only_b : place.neither);
    }
  }
  place.test = mcnemar(place.only_a, place.only_b);
  return place;
}

// Pairs that nobody tried are left out.
std::vector<FailurePair> pairs_at(int task, int target, const std::vector<Failed>& columns) {
  std::vector<FailurePair> family;
  std::vector<double> p;
  for (int a = 0; a < size_of(columns); ++a) {
    for (int b = a + 1; b < size_of(columns); ++b) {
      const FailurePair pair = pair_of({task, target, a, b}, item(columns, a), item(columns, b));
      if (pair.n() == 0) continue;
      family.push_back(pair);
      p.push_back(pair.test.p_exact);
    }
  }
  const std::vector<double> adjusted = adjust_holm(p);
  for (std::size_t i = 0; i < family.size(); ++i) {
    family[i].p_holm = adjusted[i];
    family[i].family = size_of(family);
  }
  return family;
}

// n is 0 where nobody tried the target with all of at least two interfaces.
FailureOmnibus omnibus_at(int task, int target, const std::vector<Failed>& columns) {
  FailureOmnibus omnibus{task, target, {}, {}};
  for (int i = 0; i < size_of(columns); ++i) {
    const Failed& column = item(columns, i);
    if (std::any_of(column.begin(), column.end(), [](const auto& one) { return one; })) {
      omnibus.interfaces.push_back(i);
    }
  }
  std::vector<std::vector<bool>> rows;
  const std::size_t people = columns.empty() ? 0 : columns[0].size();
  for (std::size_t person = 0; person < people; ++person) {
    std::vector<bool> row;
    for (const int i : omnibus.interfaces) {
      if (item(columns, i)[person]) row.push_back(*item(columns, i)[person]);
    }
    if (row.size() == omnibus.interfaces.size()) rows.push_back(std::move(row));
  }
  if (omnibus.interfaces.size() >= 2 && !rows.empty()) omnibus.test = cochran_q(rows);
  return omnibus;
}

void add_target(FailureTests& tests, const Dataset& data, int task, int target) {
  std::vector<Failed> columns;
  for (int i = 0; i < size_of(data.interfaces); ++i) {
    columns.push_back(failed_at(data, task, target, i));
  }
  const std::vector<FailurePair> pairs = pairs_at(task, target, columns);
  tests.pairs.insert(tests.pairs.end(), pairs.begin(), pairs.end());
  FailureOmnibus omnibus = omnibus_at(task, target, columns);
  if (omnibus.test.n > 0) tests.omnibus.push_back(std::move(omnibus));
}

}  // namespace

bool can_fail(const Dataset& data, int task) {
  const Task& one = item(data.tasks, task);
  return one.limit_s || one.threshold_m ||
         std::any_of(data.trials.begin(), data.trials.end(),
                     [task](const Trial& trial) { return trial.task == task && trial.failed; });
}

FailureTests failure_tests(const Dataset& data) {
  FailureTests tests;
  for (int task = 0; task < size_of(data.tasks); ++task) {
    if (!can_fail(data, task)) continue;
    for (Comparison& one : compare_shares(data, task)) tests.shares.push_back(std::move(one));
    for (int target = 0; target < size_of(item(data.tasks, task).targets); ++target) {
      add_target(tests, data, task, target);
    }
  }
  return tests;
}

}  // namespace promenade::analysis
