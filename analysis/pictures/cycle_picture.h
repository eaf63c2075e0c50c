// What `set build --pictures` draws: for each cycle, where it was found and how it closes.
#pragma once

#include <string>

#include "motion/set_builder.h"

namespace promenade::analysis {

// An SVG of a cycle that was built with SetOptions::keep_takes: the contacts of its whole
// take with all cycles that were found; heights and speeds of both feet around the chosen
// one, with its keytimes; its first and last pose and what became of them at the seam.
std::string cycle_picture(const motion::BuiltSet& built, const motion::CycleReport& report);

}  // namespace promenade::analysis
