#include "analysis/report/sentences.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "analysis/format.h"
#include "analysis/item.h"
#include "study/outline.h"

namespace promenade::analysis {
namespace {

// "came 0.9 cm closer", "were 3 s faster", "had 2.1 fewer mouse clicks".
std::string advantage(const Measure& measure, double amount) {
  const std::string much = with_unit(measure, amount);
  if (measure.name == "time_s") return "were " + much + " faster";
  if (measure.name == "d_final" || measure.name == "d_best") return "came " + much + " closer";
  if (measure.name == "d_first") return "began " + much + " closer";
  if (measure.name == "clicks" || measure.name == "changes") {
    return "needed " + much + " fewer " + measure.label;
  }
  if (measure.name == "asked_quality" || measure.name == "rated_quality") {
    return "found walks with " + much + " less of the asked quality";
  }
  if (measure.kind != MeasureKind::rating) return "had " + much + " less " + measure.label;
  return "answered " + much + " lower on “" + measure.label + "”";
}

// The family is what was tested: pairs that nobody could have are not in it.
std::string p_with_family(const Comparison& comparison) {
  const char* kind = comparison.test.exact ? "exact p" : "p";
  const int pairs = comparison.family;
  if (pairs <= 1) return fmt::format("{} {}", kind, p_text(*comparison.p));
  return fmt::format("{} {}, Holm over {} pairs", kind, p_text(*comparison.p_holm), pairs);
}

const char* who_took_part(const Dataset& data) {
  return data.all_simulated ? "simulated participants" : "people";
}

// "(95 % CI 0.4 to 1.5; n = 37; exact p = .004)"; sign turns a - b round.
std::string evidence(const Measure& measure, const Comparison& comparison, double sign) {
  std::string ci = "no 95 % CI with so few people";
  if (comparison.hl_ci) {
    const Interval& i = comparison.hl_ci->interval;
    const Interval turned = sign > 0 ? i : Interval{-i.upper, -i.lower};
    ci = "95 % CI " + shown_interval(measure, turned);
  }
  return fmt::format("({}; n = {}; {})", ci, comparison.test.n, p_with_family(comparison));
}

// The smallest two-sided p that so many non-zero differences can have.
double smallest_p(const Comparison& comparison) {
  const int n = comparison.test.n - comparison.test.n_zero;
  return std::min(1.0, std::ldexp(1.0, 1 - n));
}

// Where no outcome could have been significant.
std::string too_few(const SignedRankTest& test, const Measure& measure, const std::string& a,
                    const std::string& b) {
  const int differing = test.n - test.n_zero;
  if (test.n == 1) {
    return fmt::format("One participant is too few to compare {} with {}.", a, b);
  }
  if (test.n_zero == 0) {
    return fmt::format("{} participants are too few to compare {} with {}.", test.n, a, b);
  }
  return fmt::format(
      "Only {} of {} participants had a different {} with {} than with {}: too few "
      "for a test.",
      differing, test.n, measure.label, a, b);
}

std::string only_interface(const Results& results, int measure, int task) {
  const auto summaries = results.summaries_of(measure, task);
  if (summaries.empty()) return "There are no values.";
  const Summary& summary = *summaries[0];
  const Measure& m = item(results.data.measures, measure);
  std::string text = fmt::format(
      "Only one interface was used, {}, so there is nothing to compare: median {} {}",
      item(results.data.interfaces, summary.interface), m.label, with_unit(m, *summary.median));
  if (summary.median_ci) {
    text += fmt::format(" (95 % CI {}; n = {})", shown_interval(m, *summary.median_ci), summary.n);
  } else {
    text += fmt::format(" (n = {}, too few for an interval)", summary.n);
  }
  return text + ".";
}

// Which pair to speak of: one that differs before one that does not, then the larger
// difference.
bool stronger(const Comparison* a, const Comparison* b) {
  if (is_significant(*a) != is_significant(*b)) return is_significant(*a);
  return std::abs(a->hl.value_or(0)) > std::abs(b->hl.value_or(0));
}

std::string how_many_differ(const std::vector<const Comparison*>& pairs) {
  const auto count = std::count_if(pairs.begin(), pairs.end(),
                                   [](const Comparison* pair) { return is_significant(*pair); });
  const int family = pairs[0]->family;
  return family > 1 ? fmt::format(" {} of {} pairs differ.", count, family) : "";
}

// Targets that were made with the parameters of one interface are easy for that one
// (docs/methods.md, 3). Names of the interfaces of this type.
std::string uses_of(const study::Outline& outline, const std::string& type) {
  std::string names;
  for (std::size_t i = 0; i < std::min(outline.types.size(), outline.interfaces.size()); ++i) {
    if (outline.types[i] != type) continue;
    names += (names.empty() ? "" : ", ") + outline.interfaces[i];
  }
  return names;
}

void add_favoured(const Results& results, std::vector<std::string>& sentences) {
  const study::Outline outline = study::outline_of(results.log.config_text);
  if (outline.interfaces.size() < 2) return;
  for (const study::OutlinedDraw& draw : outline.draws) {
    const bool sliders = draw.model == "adjectives" || draw.model == "features";
    const std::string names = sliders ? uses_of(outline, draw.model) : "";
    if (names.empty()) continue;
    sentences.push_back(fmt::format(
        "The targets of task {} were drawn as random settings of the sliders of {}, so that its "
        "sliders can always reach them: this favours {}.",
        draw.task, draw.model, names));
  }
}

}  // namespace

bool is_significant(const Comparison& comparison) {
  return comparison.p_holm && *comparison.p_holm < significance;
}

std::string sentence_on(const Dataset& data, const Comparison& comparison) {
  const Measure& measure = item(data.measures, comparison.measure);
  const std::string& a = item(data.interfaces, comparison.a);
  const std::string& b = item(data.interfaces, comparison.b);
  const SignedRankTest& test = comparison.test;
  if (test.n == 0) {
    return fmt::format("Nobody has a value of {} with both {} and {}.", measure.label, a, b);
  }
  if (test.n == test.n_zero) {
    return fmt::format("{} had the same {} with {} as with {}.",
                       test.n == 1 ? "The only participant"
                                   : fmt::format("All {} {}", test.n, who_took_part(data)),
                       measure.label, a, b);
  }
  // By ranks where the estimate itself is zero.
  const bool a_lower = *comparison.hl != 0 ? *comparison.hl < 0 : *test.rank_biserial < 0;
  const double sign = a_lower ? -1 : 1;
  const double amount = std::abs(*comparison.hl);
  if (smallest_p(comparison) >= significance) {
    return too_few(test, measure, a, b) + fmt::format(" {} was {} lower with {}.",
                                                      capitalised(measure.label),
                                                      with_unit(measure, amount), a_lower ? a : b);
  }
  if (!is_significant(comparison)) {
    return fmt::format("No difference in {} between {} and {} could be shown: {} − {} = {} {}.",
                       measure.label, a, b, a, b, with_unit(measure, *comparison.hl),
                       evidence(measure, comparison, 1));
  }
  return fmt::format("With {} {} {} than with {} {}.", a_lower ? a : b, who_took_part(data),
                     advantage(measure, amount), a_lower ? b : a,
                     evidence(measure, comparison, sign));
}

std::string sentence_on_measure(const Results& results, int measure, int task) {
  const auto pairs = results.pairs(measure, task);
  const std::string where =
      results.data.tasks.size() > 1 ? "Task " + item(results.data.tasks, task).name + ": " : "";
  if (pairs.empty() || results.summaries_of(measure, task).size() < 2) {
    return where + only_interface(results, measure, task);
  }
  const Comparison& pair = **std::min_element(pairs.begin(), pairs.end(), stronger);
  std::string sentence = where + sentence_on(results.data, pair);
  if (is_significant(pair)) sentence += how_many_differ(pairs);
  return sentence;
}

std::vector<Spotlight> spotlights(const Results& results) {
  std::vector<Spotlight> found;
  // What other people say of what was made comes before what a model says of it.
  const bool rated = results.data.measure("rated_quality") >= 0;
  for (const char* name : {"d_final", rated ? "rated_quality" : "asked_quality", "time_s"}) {
    const int measure = results.data.measure(name);
    if (measure < 0) continue;
    for (int task = 0; task < size_of(results.data.tasks); ++task) {
      if (results.summaries_of(measure, task).empty()) continue;
      found.push_back({measure, task});
      break;
    }
  }
  return found;
}

std::vector<std::string> caveats(const Results& results) {
  std::vector<std::string> sentences;
  const Selection& selection = results.selection;
  const int n = selection.count(Disposition::analysed);
  if (n == 1) sentences.emplace_back("One person was analysed: nothing here speaks for others.");
  if (n > 1 && n < 6) {
    sentences.push_back(fmt::format(
        "With {} people no two-sided signed-rank test can reach p < .05 and no 95 % interval "
        "exists.",
        n));
  }
  if (results.data.left_out_trials > 0) {
    sentences.push_back(count_of(results.data.left_out_trials, "trial was", "trials were") +
                        " skipped, aborted or cut off and " +
                        (results.data.left_out_trials == 1 ? "counts" : "count") + " as missing.");
  }
  for (const std::string& code : selection.shared_codes) {
    sentences.push_back("The code " + code +
                        " belongs to several people of different files; they are told apart as " +
                        code + "/1, " + code + "/2 and so on.");
  }
  if (results.log.not_finite > 0) {
    sentences.push_back(count_of(results.log.not_finite, "logged value is", "logged values are") +
                        " not finite and taken for missing.");
  }
  if (results.log.repeated_sessions > 0) {
    sentences.push_back(
        count_of(results.log.repeated_sessions, "session stands", "sessions stand") +
        " in more than one file; each was taken from the first.");
  }
  add_favoured(results, sentences);
  return sentences;
}

}  // namespace promenade::analysis
