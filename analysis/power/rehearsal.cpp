#include "analysis/power/rehearsal.h"

#include <algorithm>
#include <map>

#include "analysis/comparisons.h"
#include "analysis/format.h"
#include "analysis/item.h"
#include "analysis/parallel.h"
#include "motion/problem.h"
#include "study/rng.h"

namespace promenade::analysis {
namespace {

// One measure in one task: what every study found, by number of participants.
struct Place {
  std::string task;
  Measure measure;
};

struct Found {
  std::string a, b;
  PairFinding finding;
  std::vector<double> d;  // of the largest number of participants only
};

using Family = std::vector<Found>;                                       // the pairs
using Families = std::map<std::pair<std::string, std::string>, Family>;  // by task and measure

bool wanted(const std::vector<std::string>& names, const std::string& name) {
  return names.empty() || std::find(names.begin(), names.end(), name) != names.end();
}

std::vector<std::string> measures_of(const Rehearsal& rehearsal) {
  if (!rehearsal.measures.empty()) return rehearsal.measures;
  return {"d_final", "time_s"};
}

Families test_study(const Rehearsal& rehearsal, const Dataset& data, bool keep_differences) {
  Families families;
  for (int task = 0; task < size_of(data.tasks); ++task) {
    const std::string& name = item(data.tasks, task).name;
    if (!wanted(rehearsal.tasks, name)) continue;
    for (const std::string& measure : measures_of(rehearsal)) {
      const int index = data.measure(measure);
      if (index < 0 || !data.occurs(index, task)) continue;
      Family& family = families[{name, measure}];
      for (Comparison& one : compare_participants(data, index, task)) {
        family.push_back({item(data.interfaces, one.a),
                          item(data.interfaces, one.b),
                          {one.p, one.p_holm, one.hl},
                          {}});
        if (keep_differences) family.back().d = std::move(one.d);
      }
    }
  }
  return families;
}

// What is found in all studies: [number of participants][study].
struct Rehearsed {
  std::vector<std::vector<Families>> found;
  std::vector<Measure> measures;   // as the first study has them
  std::vector<std::string> tasks;  // in the order of the study
};

Rehearsed rehearse_all(const Rehearsal& rehearsal, const PowerQuestion& question) {
  const int most = *std::max_element(question.participants.begin(), question.participants.end());
  Rehearsed all;
  all.found.assign(question.participants.size(),
                   std::vector<Families>(static_cast<std::size_t>(question.studies)));
  for_each_index(
      question.studies,
      [&](int study) {
        const Dataset data = rehearse(rehearsal, most, question.seed, study);
        for (std::size_t i = 0; i < question.participants.size(); ++i) {
          const int people = question.participants[i];
          item(all.found[i], study) =
              test_study(rehearsal, first_people(data, people), people == most);
        }
        if (study > 0) return;
        all.measures = data.measures;
        for (const Task& task : data.tasks) all.tasks.push_back(task.name);
      },
      question.progress, "studies of " + std::to_string(most) + " rehearsed:", question.threads);
  return all;
}

// The pairs of a place, as the first study that has them orders them.
Family pairs_at(const Rehearsed& all, const std::pair<std::string, std::string>& place) {
  for (const auto& studies : all.found) {
    for (const Families& families : studies) {
      const auto found = families.find(place);
      if (found != families.end() && !found->second.empty()) return found->second;
    }
  }
  return {};
}

// What each study found of a pair; nothing where it had no such pair.
std::vector<PairFinding> findings_of(const std::vector<Families>& studies,
                                     const std::pair<std::string, std::string>& place,
                                     const Found& pair, std::vector<double>* differences) {
  std::vector<PairFinding> findings;
  for (const Families& families : studies) {
    findings.emplace_back();
    const auto family = families.find(place);
    if (family == families.end()) continue;
    for (const Found& one : family->second) {
      if (one.a != pair.a || one.b != pair.b) continue;
      findings.back() = one.finding;
      if (differences) differences->insert(differences->end(), one.d.begin(), one.d.end());
    }
  }
  return findings;
}

Rate any_of(const std::vector<Families>& studies, const std::pair<std::string, std::string>& place,
            double alpha) {
  Rate rate{0, size_of(studies)};
  for (const Families& families : studies) {
    const auto family = families.find(place);
    const bool found =
        family != families.end() &&
        std::any_of(family->second.begin(), family->second.end(), [alpha](const Found& one) {
          return one.finding.p_holm && *one.finding.p_holm <= alpha;
        });
    rate.found += found ? 1 : 0;
  }
  return rate;
}

PowerTable table_at(const Rehearsed& all, const std::string& task, const Measure& measure,
                    const PowerQuestion& question) {
  PowerTable table{task, measure, {}, {}};
  const std::pair place{task, measure.name};
  const auto numbers = question.participants.size();
  for (const Found& pair : pairs_at(all, place)) {
    std::vector<double> differences;
    for (const auto& studies : all.found) findings_of(studies, place, pair, &differences);
    for (std::size_t i = 0; i < numbers; ++i) {
      PowerRow row = power_row(findings_of(all.found[i], place, pair, nullptr), question.alpha);
      row.a = pair.a;
      row.b = pair.b;
      row.participants = question.participants[i];
      add_formulas(row, differences, question.alpha);
      table.rows.push_back(std::move(row));
    }
  }
  for (std::size_t i = 0; i < numbers; ++i) {
    table.any.emplace_back(question.participants[i], any_of(all.found[i], place, question.alpha));
  }
  return table;
}

// A name that nothing in the first study has.
void refuse_unknown(const Rehearsal& rehearsal, const Rehearsed& all) {
  std::vector<std::string> measures;
  for (const Measure& one : all.measures) measures.push_back(one.name);
  const auto check = [&](const std::vector<std::string>& names,
                         const std::vector<std::string>& known, const std::string& what) {
    for (const std::string& name : names) {
      if (std::find(known.begin(), known.end(), name) != known.end()) continue;
      throw InputError("promenade power", "the study has no " + what + " \"" + name +
                                              "\" that people were compared by; it has " +
                                              listed(known));
    }
  };
  check(rehearsal.tasks, all.tasks, "task");
  check(rehearsal.measures, measures, "measure");
}

}  // namespace

Dataset rehearse(const Rehearsal& rehearsal, int participants, std::uint64_t seed, int study) {
  study::Store store(":memory:", *rehearsal.bundle);
  study::Cohort cohort;
  cohort.participants = participants;
  cohort.seed = study::Rng(seed, static_cast<std::uint64_t>(study), "rehearsal").next();
  cohort.tendencies = rehearsal.tendencies;
  study::simulate_cohort(*rehearsal.bundle, *rehearsal.registry, store, cohort);
  const Log log = read_log(store.database());
  SelectionOptions options;
  options.include_simulated = true;
  return make_dataset(log, select(log, options));
}

Dataset first_people(const Dataset& data, int people) {
  Dataset some = data;
  if (people >= size_of(data.people)) return some;
  some.people.resize(static_cast<std::size_t>(people));
  some.trials.erase(std::remove_if(some.trials.begin(), some.trials.end(),
                                   [people](const Trial& trial) { return trial.person >= people; }),
                    some.trials.end());
  return some;
}

std::vector<PowerTable> rehearsed_power(const Rehearsal& rehearsal, const PowerQuestion& question) {
  PowerQuestion first = question;  // names are looked up before the long work
  first.studies = 1;
  first.participants = {2};
  first.progress = {};
  refuse_unknown(rehearsal, rehearse_all(rehearsal, first));
  const Rehearsed all = rehearse_all(rehearsal, question);
  std::vector<PowerTable> tables;
  for (const std::string& task : all.tasks) {
    for (const std::string& name : measures_of(rehearsal)) {
      for (const Measure& measure : all.measures) {
        if (measure.name != name) continue;
        PowerTable table = table_at(all, task, measure, question);
        if (!table.rows.empty()) tables.push_back(std::move(table));
      }
    }
  }
  return tables;
}

}  // namespace promenade::analysis
