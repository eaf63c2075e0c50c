// What `set build` and `set info` tell about the cycles of a set.
#pragma once

#include <string>

#include "app/print.h"
#include "motion/set_builder.h"

namespace promenade::app {

std::string build_table(const motion::BuiltSet& built);
// A list: each cycle as in info_json with what planting its feet changed, and each take
// that gave none as {source, refusal}.
Json build_json(const motion::BuiltSet& built);

std::string info_table(const motion::MotionSet& set);
Json info_json(const motion::MotionSet& set);

}  // namespace promenade::app
