#include "analysis/report/methods_draft.h"

#include <fmt/format.h>

#include <algorithm>

#include "analysis/format.h"
#include "analysis/item.h"
#include "analysis/report/references.h"

namespace promenade::analysis {
namespace {

// "a, b and c".
std::string listed(const std::vector<std::string>& names) {
  std::string text;
  for (int i = 0; i < size_of(names); ++i) {
    if (i > 0) text += i + 1 == size_of(names) ? " and " : ", ";
    text += item(names, i);
  }
  return text;
}

bool is_simulated(const Dataset& data) { return data.all_simulated; }

std::string participants(const Results& results) {
  const Selection& selection = results.selection;
  const int analysed = selection.count(Disposition::analysed);
  std::string text =
      fmt::format("{} took part; the data of {} were analysed",
                  count_of(size_of(selection.people),
                           is_simulated(results.data) ? "simulated participant" : "person",
                           is_simulated(results.data) ? "simulated participants" : "people"),
                  analysed);
  std::vector<std::string> gone;
  const auto add = [&](Disposition disposition, const char* what) {
    const int count = selection.count(disposition);
    if (count > 0) gone.push_back(fmt::format("{} {}", count, what));
  };
  add(Disposition::declined, "declined");
  add(Disposition::withdrawn, "withdrew");
  add(Disposition::unfinished, "did not finish");
  add(Disposition::excluded, "were excluded by us [say why]");
  if (!gone.empty()) text += " (" + listed(gone) + ")";
  return text + ". [Say who they were and how they were found.]";
}

std::string order_in_words(const std::string& order) {
  if (order == "williams") {
    return " The order of the interfaces followed a Williams design, which balances position and "
           "first-order carry-over.";
  }
  if (order == "latin") return " The order of the interfaces followed a Latin square.";
  if (order == "random") return " The order of the interfaces was random for each participant.";
  if (order == "fixed") {
    return " The order of the interfaces was the same for all, so that effects of the interface "
           "and of practice cannot be told apart.";
  }
  return "";
}

std::string task_in_words(const Task& task) {
  std::vector<std::string> more;
  if (task.guess) more.emplace_back("made without seeing the walk");
  if (task.limit_s) more.push_back(fmt::format("at most {} s each", exact_number(*task.limit_s)));
  if (task.threshold_m) {
    more.push_back(fmt::format("successful below D = {} cm", fixed(*task.threshold_m * 100, 1)));
  }
  const std::string what =
      fmt::format("{} ({}", task.name, count_of(size_of(task.targets), "target", "targets"));
  return what + (more.empty() ? "" : ", " + listed(more)) + ")";
}

std::string design(const Results& results) {
  const Dataset& data = results.data;
  std::vector<std::string> tasks;
  for (const Task& task : data.tasks) tasks.push_back(task_in_words(task));
  std::string text;
  if (data.interfaces.size() > 1) {
    text = fmt::format("In a within-participants study, {} interfaces were compared: {}.",
                       data.interfaces.size(), listed(data.interfaces)) +
           order_in_words(data.order);
  } else {
    text = fmt::format("One interface was used: {}.", listed(data.interfaces));
  }
  return text + fmt::format(
                    " The {}: {}. {} entered the analysis (practice is not counted); {} skipped, "
                    "aborted or cut off and {} as missing.",
                    tasks.size() == 1 ? "task was" : "tasks were", listed(tasks),
                    count_of(size_of(data.trials), "trial", "trials"),
                    count_of(data.left_out_trials, "was", "were"),
                    data.left_out_trials == 1 ? "counts" : "count");
}

// Nobody may take simulated raters for people's opinion.
std::string adjectives(const Results& results) {
  if (!results.adjectives) return "";
  const AdjectiveSource& from = *results.adjectives;
  if (from.simulated) {
    return " Sliders between adjectives were made of ratings by simulated raters (" + from.source +
           "): no person judged the motions.";
  }
  return fmt::format(" Sliders between adjectives were made of ratings by {} ({}).",
                     count_of(from.raters, "person", "people"), from.source);
}

std::string measures(const Results& results) {
  std::string text =
      "D is the mean distance between the joints of the target and of the created walk over one "
      "cycle. Time runs from the start of a trial to its end without pauses";
  const auto& tasks = results.data.tasks;
  const bool limited = std::any_of(tasks.begin(), tasks.end(),
                                   [](const Task& task) { return task.limit_s.has_value(); });
  text += limited ? " and is restricted to the time limit." : ".";
  if (results.failures.empty()) return text;
  return text + " A trial failed when it ran out of time or was ended with D above the threshold.";
}

// How many tests were adjusted together: tasks may have different interfaces.
std::string family_in_words(const Results& results) {
  int least = 0, most = 0;
  for (const Comparison& one : results.comparisons) {
    if (one.pooling != Pooling::participants || one.family == 0) continue;
    least = least == 0 ? one.family : std::min(least, one.family);
    most = std::max(most, one.family);
  }
  if (least == most) return "the " + count_of(most, "pair", "pairs");
  return fmt::format("the pairs (up to {})", most);
}

std::string tests_of_pairs(const Results& results) {
  return fmt::format(
      "For each participant and interface the mean over the targets of a task was taken. Pairs of "
      "interfaces were compared by two-sided Wilcoxon signed-rank tests with p from the exact "
      "conditional distribution given the ranks (zeros dropped, ties by midranks). We report the "
      "matched-pairs rank-biserial correlation and the Hodges-Lehmann estimate of the difference "
      "with 95 % confidence intervals. p values were adjusted by Holm’s method over {} of one "
      "measure in one task; measures were not adjusted for each other.",
      family_in_words(results));
}

std::string other_tests(const Results& results) {
  std::string text;
  if (!results.omnibus.empty()) {
    text += " All interfaces at once were compared by Friedman’s test with Kendall’s W.";
  }
  if (tests_failures(results)) {
    text +=
        " Failures were compared by signed-rank tests of each participant’s share of failed "
        "trials, and target by target by McNemar’s exact test and Cochran’s Q; shares have Wilson "
        "and Clopper-Pearson intervals.";
  }
  if (!results.times.empty()) {
    text +=
        " As a sensitivity analysis, times were also treated as right-censored at failures: "
        "Kaplan-Meier medians, restricted means, and log-rank tests stratified by participant.";
  }
  if (results.preference.n > 0) {
    text += results.preference.test
                ? " Preferences were tested by an exact multinomial test and binomial tests of "
                  "pairs."
                : " Preferences were tested by an exact two-sided binomial test.";
  }
  return text;
}

std::string tests(const Results& results) {
  if (results.data.interfaces.size() < 2) {
    return "There was only one interface, so nothing was tested; medians have the interval of the "
           "sign test.";
  }
  return tests_of_pairs(results) + other_tests(results) +
         " Differences were called significant at p < .05.";
}

std::string program(const Results& results) {
  std::vector<std::string> versions;
  for (const LoggedFile& file : results.log.files) {
    if (std::find(versions.begin(), versions.end(), file.program_version) == versions.end()) {
      versions.push_back(file.program_version);
    }
  }
  return fmt::format(
      "The study (“{}”, version {}) ran in Promenade {}; the analysis was made by "
      "Promenade " PROMENADE_VERSION ". Study, motions and texts have the SHA-256 {}.",
      results.log.study, results.log.version, listed(versions), results.log.sha256);
}

// Where walks were only rated, there is no trial of an interface to speak of.
std::string ratings(const Results& results) {
  return fmt::format("They rated walks of a set, {} in all. [Say on which questions.]",
                     count_of(results.rated_walks, "rating", "ratings"));
}

}  // namespace

std::vector<std::string> methods_draft(const Results& results) {
  if (results.data.trials.empty()) {
    return {participants(results), ratings(results), program(results)};
  }
  return {participants(results), design(results) + adjectives(results), measures(results),
          tests(results), program(results)};
}

}  // namespace promenade::analysis
