// How a foot must be moved and turned so that it stands while it should, and stays above
// the floor. Used by foot_plant only.
#pragma once

#include "motion/foot_stance.h"

namespace promenade::motion {

// Where the ankle of one foot is wanted at every phase (F). Its toe, which stands at the
// height `level`, shall stand at `floor` (metres), and neither toe nor heel come below it.
std::vector<FootTarget> foot_targets(const Walk& walk, Side side, double level, double floor);

}  // namespace promenade::motion
