#include "analysis/sensitivity.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "analysis/format.h"
#include "analysis/item.h"
#include "analysis/primary.h"

namespace promenade::analysis {
namespace {

constexpr double significance = 0.05;

int index_in(const std::vector<std::string>& names, const std::string& name) {
  const auto found = std::find(names.begin(), names.end(), name);
  return found == names.end() ? -1 : static_cast<int>(found - names.begin());
}

int task_named(const Dataset& data, const std::string& name) {
  const auto found = std::find_if(data.tasks.begin(), data.tasks.end(),
                                  [&](const Task& task) { return task.name == name; });
  return found == data.tasks.end() ? -1 : static_cast<int>(found - data.tasks.begin());
}

SensitivityResult result_of(const Comparison& from) {
  SensitivityResult result{from.measure, from.task, from.a,      from.b, from.test.n,
                           from.hl,      from.p,    from.p_holm, {},     {}};
  result.hl_ci = interval_of(from.hl_ci);
  return result;
}

// The interfaces of `names`, one task and one measure of the data set, which may lack them.
std::vector<Comparison> compare_named(const Dataset& data, const Measure& measure,
                                      const std::string& task,
                                      const std::vector<std::string>& names) {
  const int m = data.measure(measure.name);
  const int t = task_named(data, task);
  std::vector<PersonValues> values;
  for (const std::string& name : names) {
    const int i = index_in(data.interfaces, name);
    const bool known = m >= 0 && t >= 0 && i >= 0;
    values.push_back(known ? mean_per_person(data, m, i, t) : PersonValues(data.people.size()));
  }
  Comparison place;
  place.pooling = Pooling::participants;
  return compare_pairs(place, values);
}

// The primary results of `data`, those that `reference` has and named as there.
std::vector<SensitivityResult> primary_results(const Dataset& data, const Dataset& reference) {
  std::vector<SensitivityResult> results;
  for (int task = 0; task < size_of(reference.tasks); ++task) {
    for (int measure = 0; measure < size_of(reference.measures); ++measure) {
      const Measure& one = item(reference.measures, measure);
      if (!is_primary(one) || !reference.occurs(measure, task)) continue;
      for (Comparison& pair :
           compare_named(data, one, item(reference.tasks, task).name, reference.interfaces)) {
        pair.measure = measure;
        pair.task = task;
        results.push_back(result_of(pair));
      }
    }
  }
  return results;
}

bool is_significant(const SensitivityResult& result) {
  return result.p_holm && *result.p_holm < significance;
}

std::optional<bool> same(const SensitivityResult& a, const SensitivityResult& b) {
  if (!a.p_holm || !b.p_holm) return std::nullopt;
  if (is_significant(a) != is_significant(b)) return false;
  return !is_significant(a) || (*a.hl < 0) == (*b.hl < 0);
}

int people_in(const Dataset& data) {
  std::set<int> people;
  for (const Trial& trial : data.trials) people.insert(trial.person);
  return size_of(people);
}

template <typename Keep>
Dataset only(Dataset data, const Keep& keep) {
  std::vector<Trial> kept;
  std::copy_if(data.trials.begin(), data.trials.end(), std::back_inserter(kept), keep);
  data.trials = std::move(kept);
  return data;
}

std::string pair_of(const Dataset& data, const SensitivityResult& one) {
  std::string task;
  if (data.tasks.size() > 1) task = " (" + item(data.tasks, one.task).name + ")";
  return item(data.measures, one.measure).label + task + ", " + item(data.interfaces, one.a) +
         " against " + item(data.interfaces, one.b);
}

class Comparer {
 public:
  Comparer(const Log& log, const SelectionOptions& options, const Selection& selection,
           const Dataset& data)
      : log_(log), options_(options), selection_(selection), data_(data) {}

  Sensitivity compare() {
    add(SensitivityKind::all, "as reported", data_);
    made_.compared = size_of(made_.variants[0].results);
    if (made_.compared == 0) return std::move(made_);
    vary_flagged();
    vary_excluded();
    vary_versions();
    return std::move(made_);
  }

 private:
  SensitivityVariant& add(SensitivityKind kind, const std::string& name, const Dataset& data) {
    SensitivityVariant variant{kind, name, people_in(data), size_of(data.trials),
                               primary_results(data, data_)};
    made_.variants.push_back(std::move(variant));
    SensitivityVariant& added = made_.variants.back();
    for (int i = 0; i < size_of(added.results); ++i) {
      item(added.results, i).same_conclusion =
          same(item(made_.variants[0].results, i), item(added.results, i));
    }
    return added;
  }

  void vary_flagged() {
    std::set<int> people;
    int flagged = 0;
    for (const Trial& trial : data_.trials) {
      if (!trial.quality.flagged()) continue;
      ++flagged;
      people.insert(trial.person);
    }
    if (flagged == 0) return;
    const auto unflagged = [](const Trial& trial) { return !trial.quality.flagged(); };
    add(SensitivityKind::unflagged, "without flagged trials", only(data_, unflagged));
    say("Without " + count_of(flagged, "flagged trial", "flagged trials") + " of " +
        count_of(size_of(people), "person", "people"));
  }

  void vary_excluded() {
    std::vector<std::string> codes;
    for (const Person& person : selection_.people) {
      if (person.disposition == Disposition::excluded) codes.push_back(person.code);
    }
    if (codes.empty()) return;
    SelectionOptions everyone = options_;
    everyone.exclude_file.clear();
    add(SensitivityKind::with_excluded, "with the people excluded",
        make_dataset(log_, select(log_, everyone)));
    say("Without " + names_up_to_four(codes));
  }

  void vary_versions() {
    std::vector<std::set<int>> people(log_.versions.size());
    for (const Trial& trial : data_.trials) {
      people[static_cast<std::size_t>(version_of(trial))].insert(trial.person);
    }
    if (std::count_if(people.begin(), people.end(), [](const auto& of) { return !of.empty(); }) < 2)
      return;
    for (int version = 0; version < size_of(people); ++version) {
      if (item(people, version).size() < 2) continue;
      const std::string name = "version " + item(log_.versions, version).version + " alone";
      add(SensitivityKind::version, name,
          only(data_, [&](const Trial& trial) { return version_of(trial) == version; }));
      say(capitalised(name));
    }
  }

  int version_of(const Trial& trial) const {
    return item(log_.sessions, item(log_.trials, trial.logged).session).version;
  }

  // About the newest variant: "Without P07 and P21: same conclusions."
  void say(const std::string& what) {
    const SensitivityVariant& variant = made_.variants.back();
    int changed = 0, unknown = 0;
    std::string names;
    for (const SensitivityResult& one : variant.results) {
      unknown += one.same_conclusion ? 0 : 1;
      if (one.same_conclusion.value_or(true)) continue;
      if (++changed <= 2) names += (changed > 1 ? "; " : "") + pair_of(data_, one);
    }
    const int known = size_of(variant.results) - unknown;
    std::string sentence = what + ": ";
    if (known == 0) {
      sentence += "nothing is left to compare";
    } else if (changed == 0) {
      sentence += known == 1 ? "same conclusion" : "same conclusions";
    } else {
      sentence += fmt::format("{} of {} {} {}: {}", changed, known,
                              known == 1 ? "conclusion" : "conclusions",
                              changed == 1 ? "changes" : "change", names);
      if (changed > 2) sentence += fmt::format("; and {} more", changed - 2);
    }
    if (known > 0 && unknown > 0) sentence += fmt::format(" ({} cannot be compared)", unknown);
    made_.sentences.push_back(sentence + ".");
  }

  const Log& log_;
  const SelectionOptions& options_;
  const Selection& selection_;
  const Dataset& data_;
  Sensitivity made_;
};

}  // namespace

std::string names_up_to_four(const std::vector<std::string>& names) {
  const int shown = std::min(size_of(names), 4);
  const int others = size_of(names) - shown;
  std::string text;
  for (int i = 0; i < shown; ++i) {
    const bool last = i + 1 == shown && others == 0;
    text += (i == 0 ? "" : last ? " and " : ", ") + item(names, i);
  }
  if (others > 0) text += " and " + count_of(others, "other", "others");
  return text;
}

Sensitivity sensitivity_of(const Log& log, const SelectionOptions& options,
                           const Selection& selection, const Dataset& data) {
  return Comparer(log, options, selection, data).compare();
}

}  // namespace promenade::analysis
