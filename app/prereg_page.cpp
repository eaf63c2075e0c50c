#include "app/prereg_page.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "app/document.h"
#include "study/identity.h"
#include "study/plan.h"
#include "study/prereg_seal.h"
#include "study/schema.h"
#include "study/sqlite.h"

namespace promenade::app {
namespace {

using analysis::AnalysisPlan;
using analysis::HolmFamily;
using analysis::Measure;
using analysis::MeasureKind;
using analysis::PlannedMeasure;
using study::Study;
using study::Task;
using study::TaskKind;

std::string names_of(const Study& study) {
  std::string names;
  for (const auto& one : study.interfaces) names += (names.empty() ? "" : ", ") + one.name;
  return names;
}

const char* order_words(study::Order order) {
  switch (order) {
    case study::Order::williams:
      return "a Williams design: balanced for position and for the interface before";
    case study::Order::latin:
      return "a Latin square: balanced for position";
    case study::Order::random:
      return "drawn by lot for each participant";
    case study::Order::fixed:
      return "the same for everyone, as listed above";
  }
  return "";
}

std::string nesting_words(const Study& study) {
  std::string words;
  for (const study::Factor factor : study.nesting) {
    words += words.empty() ? "" : ", in it ";
    words += factor == study::Factor::interface ? "interface"
             : factor == study::Factor::task    ? "task"
                                                : "target";
  }
  return words;
}

const char* sequence_word(study::Sequence sequence) {
  return sequence == study::Sequence::random ? "drawn by lot for each participant"
                                             : "as in the study file";
}

void tell_identity(Document& page, const Prereg& prereg) {
  const study::StudyBundle& bundle = prereg.study;
  page.heading(1, "Preregistration: " + bundle.study.name);
  page.paragraph("Written by Promenade " + std::string(study::program_version()) +
                 " from the study and the plan of its analysis, before the first session.");
  page.table({"", ""}, {{"study", bundle.study.name},
                        {"version", bundle.study.version},
                        {"SHA-256 of the study file", study::sha256_hex(bundle.config_text)},
                        {"SHA-256 of all that the study shows", bundle.sha256},
                        {"SHA-256 of the motions", bundle.set_sha256},
                        {"SHA-256 of the plan", study::sha256_hex(prereg.plan_text)}});
}

void tell_hypotheses(Document& page, const AnalysisPlan& plan) {
  page.heading(2, "Hypotheses");
  page.list(plan.hypotheses);
}

std::string task_words(const Study& study, const Task& task) {
  const bool match = task.kind == TaskKind::match;
  std::string words = match                          ? "make a walk equal to a target"
                      : task.kind == TaskKind::guess ? "guess the settings of a target, unseen"
                      : task.kind == TaskKind::find  ? "find a walk with a quality"
                                                     : "rate walks";
  words +=
      fmt::format("; {} {}", task.targets.size(), task.targets.size() == 1 ? "target" : "targets");
  words += task.limit_s ? fmt::format("; limit {} s", *task.limit_s) : "; no time limit";
  if (task.threshold_m) words += fmt::format("; success below D = {:.4f} m", *task.threshold_m);
  if (!task.lists.empty()) words += fmt::format("; targets in {} lists", task.lists.size());
  if (task.interfaces.size() == study.interfaces.size()) return words;
  words += task.interfaces.empty() ? "; without an interface" : "; with";
  for (const int index : task.interfaces) {
    words += " " + study.interfaces[static_cast<std::size_t>(index)].name;
  }
  return words;
}

void tell_design(Document& page, const Prereg& prereg) {
  const Study& study = prereg.study.study;
  page.heading(2, "Design");
  page.paragraph("Every participant works with each of these interfaces: " + names_of(study) + ".");
  std::vector<Cells> tasks;
  for (const Task& task : study.tasks) tasks.push_back({task.name, task_words(study, task)});
  page.table({"task", "what participants do"}, tasks);
  page.table({"", ""},
             {{"order of interfaces", order_words(study.order)},
              {"order of tasks", sequence_word(study.task_order)},
              {"order of targets", sequence_word(study.target_order)},
              {"nesting, the outermost first", nesting_words(study)},
              {"balanced when participants are a multiple of",
               std::to_string(study::round_of_design(study))},
              {"seed of every random choice", std::to_string(study.seed)},
              {"motion set", study.set},
              {"length of a session", fmt::format("about {:.0f} minutes, by simulated people",
                                                  std::ceil(prereg.minutes.median))}});
}

void tell_people(Document& page, const AnalysisPlan& plan) {
  page.heading(2, "Participants");
  page.paragraph(fmt::format("{} participants are analysed. When to stop: {}", plan.participants,
                             plan.stopping));
}

// What table `dictionary` says of a column of `trial`, of which most measures are.
std::string dictionary_words(const std::string& column) {
  study::Database database(":memory:", study::Database::Mode::create);
  study::create_tables(database);
  study::Statement row(database,
                       "SELECT meaning FROM dictionary WHERE table_name = 'trial' AND "
                       "column_name = ?");
  row.bind(1, column);
  return row.step() ? row.text(0) : "";
}

std::string definition_of(const Measure& measure) {
  if (measure.kind == MeasureKind::rating)
    return "the answer after the trial, if the person set it";
  if (measure.name == "time_s") {
    return "time from the start of the trial to its end without pauses, restricted to the time "
           "limit; a failure counts with the time at which it ended";
  }
  if (measure.name == "first_below_us") {
    return "time from the start of the trial until D was first below the threshold";
  }
  return dictionary_words(measure.name);
}

std::string pairs_words(const PlannedMeasure& planned) {
  if (planned.pairs.empty()) return "all pairs of interfaces";
  std::string words;
  for (const auto& pair : planned.pairs) {
    words += (words.empty() ? "" : ", ") + pair.a + " and " + pair.b;
  }
  return words;
}

void tell_measures(Document& page, const Prereg& prereg) {
  page.heading(2, "Primary measures");
  const std::vector<Measure> known = analysis::measures_of(prereg.study.study);
  std::vector<Cells> rows;
  for (const PlannedMeasure& planned : prereg.plan.measures) {
    const auto found = std::find_if(known.begin(), known.end(), [&](const Measure& one) {
      return one.name == planned.measure;
    });
    rows.push_back(
        {planned.measure, found->unit, planned.task, pairs_words(planned), definition_of(*found)});
  }
  page.table({"measure", "unit", "task", "compared", "definition"}, rows);
  page.paragraph(
      "D is the mean distance between the joints of the target and of the created walk over one "
      "cycle, in metres.");
}

void tell_tests(Document& page, const AnalysisPlan& plan) {
  page.heading(2, "Tests");
  const char* family = plan.family == HolmFamily::all
                           ? "Holm's correction runs over all these tests together."
                           : "Holm's correction runs over the pairs of one measure in one task.";
  page.paragraph(fmt::format(
      "For each measure each participant has one value per interface, the mean over targets. "
      "Pairs of interfaces are compared by Wilcoxon's signed-rank test, two-sided: zeros are "
      "dropped, ties get mid-ranks, and p comes from the exact conditional distribution of W+. {} "
      "A difference is significant when the corrected p is at most {}. Estimates are "
      "Hodges-Lehmann "
      "with 95 % intervals, and the matched-pairs rank-biserial r.",
      family, plan.alpha));
  page.paragraph("Every other test is exploratory, and will be called so.");
}

void tell_exclusions(Document& page, const analysis::ExclusionRules& rules) {
  page.heading(2, "Exclusions");
  std::vector<std::string> points;
  if (rules.min_trials) {
    points.push_back(
        fmt::format("by rule: who has fewer than {} trials that count", *rules.min_trials));
  }
  if (rules.max_flagged_share) {
    points.push_back(fmt::format(
        "by rule: who has more than {} % flagged trials (interrupted, paused, more than one late "
        "frame a second, or times known to 50 ms or worse)",
        100 * *rules.max_flagged_share));
  }
  points.insert(points.end(), rules.words.begin(), rules.words.end());
  if (points.empty()) points.emplace_back("nobody who finished the session is excluded");
  page.list(points);
}

void tell_seal(Document& page, const std::string& plan_text) {
  page.heading(2, "The plan as it was given");
  page.verbatim(plan_text);
}

}  // namespace

std::string prereg_page(const Prereg& prereg, PageFormat format) {
  std::unique_ptr<Document> page;
  if (format == PageFormat::html) {
    page = std::make_unique<HtmlDocument>();
  } else {
    page = std::make_unique<MarkdownDocument>();
  }
  tell_identity(*page, prereg);
  tell_hypotheses(*page, prereg.plan);
  tell_design(*page, prereg);
  tell_people(*page, prereg.plan);
  tell_measures(*page, prereg);
  tell_tests(*page, prereg.plan);
  tell_exclusions(*page, prereg.plan.exclusions);
  tell_seal(*page, prereg.plan_text);
  return page->take("Preregistration: " + prereg.study.study.name);
}

}  // namespace promenade::app
