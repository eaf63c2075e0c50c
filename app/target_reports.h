// How far the targets of a study are, what each interface can do about them, and what is unfair.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "study/reach_models.h"

namespace promenade::app {

struct InterfaceReach {
  std::string interface;
  study::Reach reach;
};

// One target of a task with a target motion, and the interfaces of that task. A target that is
// drawn for each participant is judged by what the first few of them get.
struct TargetReport {
  std::string task, target;
  bool practice = false;
  std::optional<int> sequence;  // of the participant whose draw it is; nothing: the same for all
  std::string start;            // "average", or the task whose guess the trials begin from
  Place place;
  std::optional<double> threshold_m;
  double judged_by_m = 0;  // the threshold, or the automatic one
  std::vector<InterfaceReach> reaches;
};

// Thousands of targets take minutes: `goes_on` is told what is done of how many, and says whether
// to go on.
std::vector<TargetReport> report_targets(
    const study::StudyBundle& bundle,
    const std::function<bool(const std::vector<TargetReport>& done, std::size_t count)>& goes_on);

// What is legal but unwise. Targets that are drawn for each participant are one warning.
std::vector<Problem> warnings_of(const std::string& file, const std::vector<TargetReport>& reports);

}  // namespace promenade::app
