#include "app/target_reports.h"

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
    report.reaches.push_back({name, study::reach(bundle, interfaces(), models, task, index,
                                                 one.target, report.judged_by_m)});
  }
  return report;
}

// Reports that are judged together: one fixed target, or all that one source draws.
using Group = std::vector<const TargetReport*>;
using Sentences = std::vector<std::string>;

std::vector<Group> grouped(const std::vector<TargetReport>& reports) {
  std::vector<Group> groups;
  for (const TargetReport& report : reports) {
    const auto belongs = [&](const Group& group) {
      const TargetReport& first = *group.front();
      return report.sequence && first.sequence && first.task == report.task &&
             first.practice == report.practice && first.place.line == report.place.line &&
             first.place.column == report.place.column;
    };
    const auto found = std::find_if(groups.begin(), groups.end(), belongs);
    if (found == groups.end()) {
      groups.push_back({&report});
    } else {
      found->push_back(&report);
    }
  }
  return groups;
}

void warn_of_reach(const Group& group, std::size_t interface, Sentences& warnings) {
  const TargetReport& first = *group.front();
  const auto out = std::count_if(group.begin(), group.end(), [&](const TargetReport* report) {
    return report->reaches[interface].reach.best >= *report->threshold_m;
  });
  if (out == 0) return;
  const InterfaceReach& one = first.reaches[interface];
  if (!first.sequence) {
    warnings.push_back(fmt::format(
        "task \"{}\": with interface \"{}\" the target \"{}\" seems out of reach: the best D "
        "found is {:.4f} m, the threshold {:.4f} m",
        first.task, one.interface, first.target, one.reach.best, *first.threshold_m));
    return;
  }
  warnings.push_back(fmt::format(
      "task \"{}\": with interface \"{}\" {} of {} walks that the first {} participants get seem "
      "out of reach; the threshold is {:.4f} m",
      first.task, one.interface, out, group.size(), judged_draws, *first.threshold_m));
}

// Of the settings of an interface that meet the target by chance, over a group. A share of 0
// stands for less than one of the settings that were tried: `at_most`.
struct Share {
  const std::string* interface = nullptr;
  double found = 0, at_most = 0;
};

Share share_of(const Group& group, std::size_t interface) {
  Share share{&group.front()->reaches[interface].interface};
  for (const TargetReport* report : group) {
    const study::Reach& reach = report->reaches[interface].reach;
    const double one = 0.5 / std::max(1, reach.settings);
    share.found += reach.share_below / static_cast<double>(group.size());
    share.at_most += std::max(reach.share_below, one) / static_cast<double>(group.size());
  }
  return share;
}

void warn_of_shares(const Group& group, Sentences& warnings) {
  const TargetReport& first = *group.front();
  if (first.reaches.size() < 2) return;
  Share low = share_of(group, 0);
  Share high = low;
  for (std::size_t i = 1; i < first.reaches.size(); ++i) {
    const Share share = share_of(group, i);
    if (share.at_most < low.at_most) low = share;
    if (share.found > high.found) high = share;
  }
  if (high.found <= fair_ratio * low.at_most) return;
  const std::string target = first.sequence ? std::string("a walk drawn for each participant")
                                            : "target \"" + first.target + "\"";
  warnings.push_back(fmt::format(
      "task \"{}\": by chance, {} is met by {:.1f} % of the settings of \"{}\", but by "
      "{:.1f} % of those of \"{}\"; the task favours one interface",
      first.task, target, 100 * high.found, *high.interface, 100 * low.found, *low.interface));
}

}  // namespace

std::vector<TargetReport> report_targets(
    const StudyBundle& bundle,
    const std::function<bool(const std::vector<TargetReport>& done, std::size_t count)>& goes_on) {
  std::vector<TargetReport> reports;
  const std::vector<Case> cases = cases_of(bundle.study);
  if (cases.empty()) return reports;
  const study::ReachModels models = study::make_reach_models(bundle);
  for (const Case& one : cases) {
    reports.push_back(report_case(bundle, models, one));
    if (!goes_on(reports, cases.size())) break;
  }
  return reports;
}

std::vector<Problem> warnings_of(const std::string& file,
                                 const std::vector<TargetReport>& reports) {
  std::vector<Problem> warnings;
  for (const Group& group : grouped(reports)) {
    const TargetReport& first = *group.front();
    if (!first.threshold_m) continue;
    Sentences sentences;
    for (std::size_t i = 0; i < first.reaches.size(); ++i) warn_of_reach(group, i, sentences);
    warn_of_shares(group, sentences);
    for (std::string& sentence : sentences) {
      warnings.push_back(
          {file, first.place.line, first.place.column, std::move(sentence), Severity::warning});
    }
  }
  return warnings;
}

}  // namespace promenade::app
