#include "analysis/prereg/prereg_check.h"

#include <algorithm>
#include <map>

#include "analysis/format.h"
#include "analysis/item.h"
#include "analysis/prereg/sealed_plan.h"
#include "analysis/results.h"
#include "analysis/statistics/p_adjust.h"
#include "study/identity.h"

namespace promenade::analysis {
namespace {

bool counts(const LoggedSession& session, const SelectionOptions& options) {
  return (!session.simulated || options.include_simulated) &&
         (!session.pilot || options.include_pilot);
}

// Sessions that ran on a version of the study that does not name this document.
int unsealed_sessions(const Results& results, const std::string& sha256) {
  const auto& sessions = results.log.sessions;
  return static_cast<int>(
      std::count_if(sessions.begin(), sessions.end(), [&](const LoggedSession& session) {
        const LoggedVersion& version = item(results.log.versions, session.version);
        return counts(session, results.options) && version.seal != sha256;
      }));
}

SealState state_of(const Results& results, const std::string& sha256) {
  const auto& versions = results.log.versions;
  const bool named = std::any_of(versions.begin(), versions.end(),
                                 [&](const LoggedVersion& one) { return one.seal == sha256; });
  if (named) return unsealed_sessions(results, sha256) == 0 ? SealState::sealed : SealState::late;
  const bool any = std::any_of(versions.begin(), versions.end(),
                               [](const LoggedVersion& one) { return !one.seal.empty(); });
  return any ? SealState::other : SealState::none;
}

PlannedTest test_of(const PlannedMeasure& planned, const std::string& a, const std::string& b) {
  PlannedTest test;
  test.measure = planned.measure;
  test.task = planned.task;
  test.a = a;
  test.b = b;
  return test;
}

class Checker {
 public:
  Checker(const Results& results, PreregCheck& check) : results_(results), check_(check) {}

  void check(const std::string& document) {
    check_seal();
    check_study(document);
    check_people();
    check_exclusions();
    find_tests();
    adjust();
  }

 private:
  void deviate(std::string about, std::string planned, std::string found) {
    check_.deviations.push_back({std::move(about), std::move(planned), std::move(found)});
  }

  void check_seal() {
    check_.seal = state_of(results_, check_.sha256);
    const std::string planned = "sealed in the database before the first session";
    switch (check_.seal) {
      case SealState::sealed:
        return;
      case SealState::late:
        return deviate("seal", planned,
                       count_of(unsealed_sessions(results_, check_.sha256), "session", "sessions") +
                           " ran before it was sealed");
      case SealState::other:
        return deviate("seal", planned,
                       "another document is sealed: not this one, or not as it is");
      case SealState::none:
        return deviate("seal", planned, "nothing is sealed: the study names no document");
    }
  }

  void check_study(const std::string& document) {
    for (const LoggedVersion& one : results_.log.versions) {
      if (document.find(one.unsealed_sha256) == std::string::npos) {
        deviate("study", "the study file whose hash the document states",
                "version \"" + one.version + "\" is another one");
      }
      if (one.amended_utc.empty()) continue;
      deviate(
          "study", "one version",
          "changed to version \"" + one.version + "\" on " + one.amended_utc + ": " + one.reason);
    }
  }

  void check_people() {
    const int analysed = results_.selection.count(Disposition::analysed);
    if (analysed != check_.plan.participants) {
      deviate(
          "participants",
          count_of(check_.plan.participants, "participant is", "participants are") + " analysed",
          std::to_string(analysed) +
              (analysed < check_.plan.participants ? ", too few" : ", more"));
    }
    if (results_.selection.any_simulated()) {
      deviate("participants", "people", "simulated participants are counted");
    }
    if (results_.selection.any_pilot()) {
      deviate("participants", "people of the study", "pilot sessions are counted");
    }
  }

  // Everyone who finished, the excluded ones too: the rules are about all of them.
  Selection finished_people() const {
    Selection selection = results_.selection;
    for (Person& person : selection.people) {
      const bool finished = person.disposition == Disposition::excluded && person.session >= 0;
      if (finished) person.disposition = Disposition::analysed;
    }
    return selection;
  }

  // Which rule puts them out, in words; empty: none.
  std::string rule_against(int trials, int flagged) const {
    const ExclusionRules& rules = check_.plan.exclusions;
    if (rules.min_trials && trials < *rules.min_trials) {
      return count_of(trials, "trial counts", "trials count");
    }
    if (rules.max_flagged_share && flagged > *rules.max_flagged_share * trials) {
      return std::to_string(flagged) + " of " + count_of(trials, "trial is", "trials are") +
             " flagged";
    }
    return "";
  }

  std::map<std::string, std::string> rule_of_people() const {
    const Dataset data = make_dataset(results_.log, finished_people());
    std::vector<int> trials(data.people.size()), flagged(data.people.size());
    for (const Trial& trial : data.trials) {
      ++item(trials, trial.person);
      item(flagged, trial.person) += trial.quality.flagged() ? 1 : 0;
    }
    std::map<std::string, std::string> rules;
    for (int i = 0; i < size_of(data.people); ++i) {
      rules[item(data.people, i)] = rule_against(item(trials, i), item(flagged, i));
    }
    return rules;
  }

  void check_exclusions() {
    std::map<std::string, std::string> rules = rule_of_people();
    for (const Person& person : results_.selection.people) {
      const std::string& rule = rules[person.code];
      if (person.disposition == Disposition::excluded && rule.empty()) {
        deviate("exclusions", "by the rules that the program checks",
                person.code + " is excluded by hand" +
                    (person.reason.empty() ? "" : ": " + person.reason));
      } else if (person.disposition == Disposition::analysed && !rule.empty()) {
        deviate("exclusions", person.code + " is excluded by rule: " + rule,
                person.code + " is analysed");
      }
    }
  }

  std::vector<PlannedTest> tests_of(const PlannedMeasure& planned) const {
    std::vector<PlannedTest> tests;
    for (const PlannedPair& pair : planned.pairs) {
      tests.push_back(test_of(planned, pair.a, pair.b));
    }
    if (!planned.pairs.empty()) return tests;
    const auto& names = results_.data.interfaces;
    for (std::size_t a = 0; a < names.size(); ++a) {
      for (std::size_t b = a + 1; b < names.size(); ++b) {
        tests.push_back(test_of(planned, names[a], names[b]));
      }
    }
    return tests;
  }

  bool is_of(const Comparison& one, const PlannedTest& test) const {
    const Dataset& data = results_.data;
    const std::string& a = item(data.interfaces, one.a);
    const std::string& b = item(data.interfaces, one.b);
    return one.pooling == Pooling::participants &&
           item(data.measures, one.measure).name == test.measure &&
           item(data.tasks, one.task).name == test.task &&
           ((a == test.a && b == test.b) || (a == test.b && b == test.a));
  }

  void find_comparison(PlannedTest& test) const {
    const auto& all = results_.comparisons;
    const auto found = std::find_if(all.begin(), all.end(),
                                    [&](const Comparison& one) { return is_of(one, test); });
    if (found == all.end()) return;
    test.comparison = static_cast<int>(found - all.begin());
    test.a = item(results_.data.interfaces, found->a);  // differences are in this order
    test.b = item(results_.data.interfaces, found->b);
  }

  void find_tests() {
    int made = 0;
    for (const PlannedMeasure& planned : check_.plan.measures) {
      for (PlannedTest& test : tests_of(planned)) {
        find_comparison(test);
        const bool has_p = test.comparison >= 0 && item(results_.comparisons, test.comparison).p;
        made += test.comparison >= 0 ? 1 : 0;
        if (!has_p) {
          deviate("measures", test.measure + " in " + test.task + ", " + test.a + " - " + test.b,
                  "there are no values of both");
        }
        check_.tests.push_back(std::move(test));
      }
    }
    check_.exploratory = size_of(results_.comparisons) - made;
  }

  bool same_family(const PlannedTest& a, const PlannedTest& b) const {
    return check_.plan.family == HolmFamily::all || (a.measure == b.measure && a.task == b.task);
  }

  void adjust() {
    for (PlannedTest& test : check_.tests) {
      std::vector<double> p;
      std::optional<std::size_t> own;
      for (const PlannedTest& other : check_.tests) {
        if (other.comparison < 0 || !same_family(test, other)) continue;
        const auto& one = item(results_.comparisons, other.comparison);
        if (!one.p) continue;
        if (&other == &test) own = p.size();
        p.push_back(*one.p);
      }
      if (own) test.p_holm = adjust_holm(p)[*own];
    }
  }

  const Results& results_;
  PreregCheck& check_;
};

}  // namespace

PreregCheck check_prereg(const Results& results, const std::string& file,
                         const std::string& document) {
  PreregCheck check;
  check.file = file;
  check.sha256 = study::sha256_hex(document);
  check.plan = read_plan(file, plan_text_in(file, document), nullptr);
  Checker(results, check).check(document);
  return check;
}

std::string to_text(SealState state) {
  switch (state) {
    case SealState::sealed:
      return "sealed";
    case SealState::late:
      return "late";
    case SealState::other:
      return "other";
    case SealState::none:
      return "none";
  }
  return "";
}

}  // namespace promenade::analysis
