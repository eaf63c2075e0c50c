#include "app/commands/target_report.h"

#include <fmt/format.h>

#include <algorithm>

#include "app/registry.h"
#include "study/plan.h"

namespace promenade::app {
namespace {

using study::StudyBundle;
using study::Target;
using study::Task;

constexpr double fair_ratio = 3;
constexpr int judged_draws = 3;

// A target with weights, to be judged.
struct Case {
  int task = 0;
  bool practice = false;
  std::optional<int> sequence;
  Target target;
};

void add_cases(const study::Study& study, int task, const Target& target, bool practice,
               std::vector<Case>& cases) {
  if (target.weights) cases.push_back({task, practice, std::nullopt, target});
  if (!target.draw) return;
  for (int sequence = 0; sequence < judged_draws; ++sequence) {
    cases.push_back({task, practice, sequence, target});
    cases.back().target.weights = study::drawn_target(study, task, target, sequence);
  }
}

std::vector<Case> cases_of(const study::Study& study) {
  std::vector<Case> cases;
  for (std::size_t i = 0; i < study.tasks.size(); ++i) {
    const Task& task = study.tasks[i];
    if (!study::has_target_motion(task.kind)) continue;
    for (const bool practice : {true, false}) {
      for (const Target& target : practice ? task.practice : task.targets) {
        add_cases(study, static_cast<int>(i), target, practice, cases);
      }
    }
  }
  return cases;
}

// By the model of the interface; one that has none is tried as it is.
study::Reach reach_of(const StudyBundle& bundle, const study::ReachModels& models, const Task& task,
                      int interface, const Target& target, double judged_by_m) {
  const std::string& type = bundle.study.interfaces[static_cast<std::size_t>(interface)].type;
  if (const motion::ControlMap* map = study::find_map(models, type)) {
    return study::reach(models, *map, target, judged_by_m, task.distance);
  }
  return study::reach(bundle, interfaces(), task, interface, target, {.threshold_m = judged_by_m});
}

std::string start_of(const study::Study& study, const Task& task) {
  if (task.start_guess < 0) return "average";
  return study.tasks[static_cast<std::size_t>(task.start_guess)].name;
}

TargetReport report_case(const StudyBundle& bundle, const study::ReachModels& models,
                         const Case& one) {
  const Task& task = bundle.study.tasks[static_cast<std::size_t>(one.task)];
  TargetReport report{task.name,
                      one.target.name,
                      one.practice,
                      one.sequence,
                      start_of(bundle.study, task),
                      one.target.place,
                      task.threshold_m,
                      study::judged_threshold(bundle.space, task),
                      {}};
  for (const int index : task.interfaces) {
    const std::string& name = bundle.study.interfaces[static_cast<std::size_t>(index)].name;
    report.reaches.push_back(
        {name, reach_of(bundle, models, task, index, one.target, report.judged_by_m)});
  }
  return report;
}

void note_progress(const StudyBundle& bundle, std::size_t done, std::size_t count) {
  show_progress("targets checked:", static_cast<int>(done), static_cast<int>(count));
  if (!interrupted()) return;
  throw OutsideError(fmt::format("stopped after {} of {} targets of {}", done, count, bundle.file));
}

std::string shown_name(const TargetReport& report) {
  if (!report.sequence) return report.target;
  return fmt::format("{} (order {})", report.target, *report.sequence);
}

using Sentences = std::vector<std::string>;

void warn_of_reach(const TargetReport& report, Sentences& warnings) {
  for (const auto& [interface, reach] : report.reaches) {
    if (reach.best < *report.threshold_m) continue;
    warnings.push_back(fmt::format(
        "task \"{}\": with interface \"{}\" the target \"{}\" seems out of reach: the best D found "
        "is {:.4f} m, the threshold {:.4f} m",
        report.task, interface, shown_name(report), reach.best, *report.threshold_m));
  }
}

// A share of 0 stands for less than one of the settings that were tried.
double share_of(const study::Reach& reach) {
  return std::max(reach.share_below, 0.5 / std::max(1, reach.settings));
}

void warn_of_shares(const TargetReport& report, Sentences& warnings) {
  if (report.reaches.size() < 2) return;
  const auto less = [](const InterfaceReach& a, const InterfaceReach& b) {
    return share_of(a.reach) < share_of(b.reach);
  };
  const auto [low, high] = std::minmax_element(report.reaches.begin(), report.reaches.end(), less);
  if (share_of(high->reach) <= fair_ratio * share_of(low->reach)) return;
  warnings.push_back(fmt::format(
      "task \"{}\": by chance, target \"{}\" is met by {:.1f} % of the settings of \"{}\", but by "
      "{:.1f} % of those of \"{}\"; the task favours one interface",
      report.task, shown_name(report), 100 * high->reach.share_below, high->interface,
      100 * low->reach.share_below, low->interface));
}

}  // namespace

std::vector<TargetReport> report_targets(const StudyBundle& bundle) {
  std::vector<TargetReport> reports;
  const std::vector<Case> cases = cases_of(bundle.study);
  if (cases.empty()) return reports;
  const study::ReachModels models = study::make_reach_models(bundle);
  for (const Case& one : cases) {
    reports.push_back(report_case(bundle, models, one));
    note_progress(bundle, reports.size(), cases.size());
  }
  return reports;
}

std::vector<Problem> warnings_of(const std::string& file, const TargetReport& report) {
  Sentences sentences;
  if (report.threshold_m) {
    warn_of_reach(report, sentences);
    warn_of_shares(report, sentences);
  }
  std::vector<Problem> warnings;
  for (std::string& sentence : sentences) {
    warnings.push_back(
        {file, report.place.line, report.place.column, std::move(sentence), Severity::warning});
  }
  return warnings;
}

Json to_json(const TargetReport& report) {
  Json json = {{"task", report.task},
               {"target", report.target},
               {"practice", report.practice},
               {"sequence", report.sequence ? Json(*report.sequence) : Json(nullptr)},
               {"start", report.start},
               {"threshold_m", to_json(report.threshold_m)},
               {"judged_by_m", report.judged_by_m}};
  json["interfaces"] = Json::array();
  for (const auto& [interface, reach] : report.reaches) {
    json["interfaces"].push_back({{"name", interface},
                                  {"d_start", reach.start},
                                  {"d_best", reach.best},
                                  {"d_best_example", reach.best_example},
                                  {"share_below", reach.share_below},
                                  {"settings", reach.settings}});
  }
  return json;
}

std::string targets_text(const std::vector<TargetReport>& reports) {
  std::string text = fmt::format("  {:<16}{:<16}{:<16}{:>10}{:>10}{:>14}{:>14}\n", "task", "target",
                                 "interface", "D start", "D best", "best example", "won by chance");
  for (const TargetReport& report : reports) {
    for (const auto& [interface, reach] : report.reaches) {
      text +=
          fmt::format("  {:<16}{:<16}{:<16}{:>10.4f}{:>10.4f}{:>14.4f}", report.task,
                      shown_name(report), interface, reach.start, reach.best, reach.best_example);
      text += report.threshold_m ? fmt::format("{:>12.1f} %\n", 100 * reach.share_below) : "\n";
    }
  }
  return text;
}

}  // namespace promenade::app
