// What `set build` and `set info` tell about the cycles of a set.
#pragma once

#include <string>

#include "app/print.h"
#include "motion/set_builder.h"

namespace promenade::app {

std::string build_table(const motion::BuiltSet& built);
Json build_json(const motion::BuiltSet& built);

std::string info_table(const motion::MotionSet& set);
Json info_json(const motion::MotionSet& set);

}  // namespace promenade::app
