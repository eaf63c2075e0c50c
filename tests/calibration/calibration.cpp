#include "calibration.h"

#include <algorithm>
#include <bit>
#include <boost/math/distributions/binomial.hpp>
#include <cassert>
#include <cmath>

#include "analysis/comparisons.h"
#include "analysis/item.h"
#include "analysis/parallel.h"
#include "analysis/statistics/logrank.h"
#include "app/registry.h"
#include "study/load_study.h"

namespace promenade::calibration {
namespace {

using analysis::Comparison;
using analysis::Dataset;
using analysis::item;
using analysis::size_of;

constexpr const char* study_text = R"(
[study]
name = "calibration"
version = "1"
set = "builtin:A"
seed = 7
order = "williams"
[[interface]]
name = "first"
type = "weights"
[[interface]]
name = "second"
type = "weights"
[[task]]
name = "match"
kind = "match"
limit_s = 40
threshold = "auto"
dwell_ms = 500
targets = [{ example = "proud" }, { example = "old" }, { example = "sneaky" }]
[[rating]]
item = "satisfaction"
question = "How satisfied are you with the walk?"
low = "not at all"
high = "completely"
points = 7
)";

const std::vector<std::string> measures = {"d_final", "time_s", "changes", "satisfaction"};

study::StudyBundle load() {
  return study::read_study("calibration.toml", study_text, app::interfaces(),
                           study::load_motion_set);
}

// Twice the mid-ranks of the magnitudes that are not zero.
std::vector<int> doubled_ranks(const std::vector<double>& differences) {
  std::vector<double> magnitudes;
  for (const double d : differences) {
    if (d != 0) magnitudes.push_back(std::abs(d));
  }
  std::vector<int> ranks;
  for (const double one : magnitudes) {
    int rank = 1;
    for (const double other : magnitudes) rank += other < one ? 2 : other == one ? 1 : 0;
    ranks.push_back(rank);
  }
  return ranks;
}

bool is_tied(const std::vector<double>& differences) {
  std::vector<int> ranks = doubled_ranks(differences);
  if (ranks.size() < differences.size()) return true;
  std::sort(ranks.begin(), ranks.end());
  return std::adjacent_find(ranks.begin(), ranks.end()) != ranks.end();
}

// What one study says of a measure.
struct Verdict {
  bool participants = false, trials = false;  // rejected
  double attainable = 0;
  bool untied = false;
};

Verdict verdict_on(const std::vector<Comparison>& comparisons, int measure, double alpha) {
  Verdict verdict;
  for (const Comparison& one : comparisons) {
    if (one.measure != measure || one.pooling == analysis::Pooling::none) continue;
    const bool rejected = one.p && *one.p <= alpha;
    if (one.pooling == analysis::Pooling::trials) {
      verdict.trials = rejected;
      continue;
    }
    verdict.participants = rejected;
    verdict.attainable = attainable_size(one.d, alpha);
    verdict.untied = !is_tied(one.d);
  }
  return verdict;
}

// The share of failures with the first interface minus that with the second, per person: a few
// values, many of them zero.
Verdict verdict_on_failures(const Dataset& data, double alpha) {
  std::vector<double> d(data.people.size(), 0.0);
  for (const analysis::Trial& trial : data.trials) {
    if (trial.failed) item(d, trial.person) += trial.interface == 0 ? 1 : -1;
  }
  const auto p = analysis::reported_p(analysis::wilcoxon(d));
  return {p && *p <= alpha, false, attainable_size(d, alpha), !is_tied(d)};
}

// The time that every trial took, or at which it was stopped.
analysis::LogRankTest logrank_of(const Dataset& data, bool stratified) {
  const int time = data.measure("time_s");
  std::vector<analysis::GroupedDuration> durations;
  for (const analysis::Trial& trial : data.trials) {
    const auto& value = item(trial.values, time);
    if (!value) continue;
    durations.push_back({{*value, !trial.failed}, trial.interface, stratified ? trial.person : 0});
  }
  return analysis::logrank(std::move(durations), 2);
}

struct StudyVerdict {
  std::vector<Verdict> measures;
  Verdict failures;
  bool stratified = false, unstratified = false;  // log-rank, rejected
};

StudyVerdict judge(const Dataset& data, double alpha) {
  StudyVerdict verdict;
  const std::vector<Comparison> comparisons = analysis::compare_all(data);
  for (const std::string& name : measures) {
    verdict.measures.push_back(verdict_on(comparisons, data.measure(name), alpha));
  }
  verdict.failures = verdict_on_failures(data, alpha);
  const auto rejects = [&](bool stratified) {
    const auto p = logrank_of(data, stratified).p;
    return p && *p <= alpha;
  };
  verdict.stratified = rejects(true);
  verdict.unstratified = rejects(false);
  return verdict;
}

std::vector<Size> add_up(const std::vector<StudyVerdict>& verdicts) {
  const int studies = size_of(verdicts);
  std::vector<Size> sizes;
  for (std::size_t m = 0; m < measures.size(); ++m) {
    Size people{measures[m], "one value per person", 0, studies, 0, 0};
    Size trials{measures[m], "pooled trials", 0, studies, 0, 0};
    for (const StudyVerdict& one : verdicts) {
      people.rejected += one.measures[m].participants ? 1 : 0;
      people.expected += one.measures[m].attainable / studies;
      people.untied += one.measures[m].untied ? 1.0 / studies : 0;
      trials.rejected += one.measures[m].trials ? 1 : 0;
    }
    sizes.push_back(people);
    sizes.push_back(trials);
  }
  Size failures{"failures", "one value per person", 0, studies, 0, 0};
  for (const StudyVerdict& one : verdicts) {
    failures.rejected += one.failures.participants ? 1 : 0;
    failures.expected += one.failures.attainable / studies;
  }
  sizes.push_back(failures);
  Size stratified{"time_s", "log-rank, stratified", 0, studies, 0, 0};
  Size unstratified{"time_s", "log-rank, pooled trials", 0, studies, 0, 0};
  for (const StudyVerdict& one : verdicts) {
    stratified.rejected += one.stratified ? 1 : 0;
    unstratified.rejected += one.unstratified ? 1 : 0;
  }
  sizes.push_back(stratified);
  sizes.push_back(unstratified);
  return sizes;
}

// work(study, its data), on all cores.
void for_each_study(const Setting& setting, const study::Tendencies& tendencies, int studies,
                    const std::string& what, const std::function<void(int, const Dataset&)>& work) {
  const study::StudyBundle bundle = load();
  const analysis::Rehearsal rehearsal{&bundle, &app::interfaces(), tendencies, {}, {}};
  analysis::for_each_index(
      studies,
      [&](int study) {
        work(study, analysis::rehearse(rehearsal, setting.people, setting.seed, study));
      },
      setting.progress, what);
}

// The differences of each study, by measure.
using Differences = std::vector<std::vector<Comparison>>;

Differences differences_of(const Setting& setting, int studies, const std::string& what) {
  study::Tendencies tendencies;
  tendencies.aptitude = setting.aptitude;
  tendencies.difficulty["second"] = 2;
  Differences all(static_cast<std::size_t>(studies));
  for_each_study(setting, tendencies, studies, what, [&](int study, const Dataset& data) {
    for (const std::string& name : measures) {
      item(all, study)
          .push_back(analysis::compare_participants(data, data.measure(name), 0).front());
    }
  });
  return all;
}

}  // namespace

double attainable_size(const std::vector<double>& differences, double alpha) {
  const std::vector<int> ranks = doubled_ranks(differences);
  assert(ranks.size() <= 20 && "too many signs to go through");
  int total = 0;
  for (const int rank : ranks) total += rank;
  std::vector<int> smaller(static_cast<std::size_t>(total) + 1, 0);  // counts of min(W+, W-)
  const std::uint32_t end = 1U << ranks.size();
  int plus = 0;
  std::uint32_t signs = 0;
  for (std::uint32_t i = 0; i < end; ++i) {  // in the order of Gray: one sign changes at a time
    ++item(smaller, std::min(plus, total - plus));
    if (i + 1 == end) break;
    const auto bit = static_cast<std::size_t>(std::countr_zero(i + 1));
    signs ^= 1U << bit;
    plus += (signs >> bit & 1U) != 0 ? ranks[bit] : -ranks[bit];
  }
  double size = 0;
  for (int sum = 0, count = 0; 2 * sum < total; ++sum) {
    count += item(smaller, sum);
    if (count > alpha * end) break;
    size = static_cast<double>(count) / end;
  }
  return size;
}

Limits binomial_limits(int n, double p, double level) {
  namespace bm = boost::math;
  const bm::binomial_distribution<double> binomial(n, p);
  Limits limits{0, n};
  while (bm::cdf(binomial, limits.least) <= (1 - level) / 2) ++limits.least;
  while (limits.most > 0 && bm::cdf(bm::complement(binomial, limits.most - 1)) <= (1 - level) / 2) {
    --limits.most;
  }
  return limits;
}

std::vector<Size> sizes_where_nothing_differs(const Setting& setting) {
  study::Tendencies tendencies;
  tendencies.aptitude = setting.aptitude;
  std::vector<StudyVerdict> verdicts(static_cast<std::size_t>(setting.studies));
  for_each_study(setting, tendencies, setting.studies,
                 "studies where nothing differs:", [&](int study, const Dataset& data) {
                   item(verdicts, study) = judge(data, setting.alpha);
                 });
  return add_up(verdicts);
}

std::vector<Coverage> coverage_of_intervals(const Setting& setting, int people) {
  const int large = people / setting.people;
  Setting other = setting;
  other.seed = setting.seed + 1;
  const Differences truth = differences_of(other, large, "studies of the large run:");
  const Differences studies = differences_of(setting, setting.studies, "studies of intervals:");
  std::vector<Coverage> all;
  for (std::size_t m = 0; m < measures.size(); ++m) {
    std::vector<double> d;
    for (const auto& study : truth) d.insert(d.end(), study[m].d.begin(), study[m].d.end());
    Coverage coverage{measures[m], 0, size_of(d), 0, 0, 0};
    coverage.shift = analysis::hodges_lehmann(analysis::WalshAverages(d)).value_or(0);
    for (const auto& study : studies) {
      const auto& interval = study[m].hl_ci;
      if (!interval) continue;
      ++coverage.studies;
      coverage.level += interval->level / setting.studies;
      const bool covered =
          interval->interval.lower <= coverage.shift && coverage.shift <= interval->interval.upper;
      coverage.covered += covered ? 1 : 0;
    }
    all.push_back(coverage);
  }
  return all;
}

}  // namespace promenade::calibration
