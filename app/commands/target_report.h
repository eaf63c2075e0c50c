// What `check` tells of the targets of a study, and how it is printed.
#pragma once

#include <string>
#include <vector>

#include "app/print.h"
#include "app/target_reports.h"

namespace promenade::app {

// Throws OutsideError when it is interrupted: thousands of targets take minutes.
std::vector<TargetReport> report_targets(const study::StudyBundle& bundle);
Json to_json(const TargetReport& report);
std::string targets_text(const std::vector<TargetReport>& reports);

}  // namespace promenade::app
