// What was registered beforehand, and what was done otherwise: with `report --prereg` only.
#pragma once

#include "analysis/report/section.h"

namespace promenade::analysis {

// Without a title where the report has no preregistration.
Section prereg_section(const Results& results);

}  // namespace promenade::analysis
