// The parameters of the interface "map", as its model takes them.
#pragma once

#include <optional>

#include "motion/models/map.h"
#include "study/interface.h"

namespace promenade::study {

// By the names heuristic, metric, components, nearest and glide_s; what is not there has
// its standard.
motion::MapOptions map_options(const Parameters& parameters);

// "zero", "closest", "weights", "random"; nothing: no heuristic.
std::optional<motion::MapHeuristic> map_heuristic(std::string_view name);
std::string_view name_of(motion::MapHeuristic heuristic);

}  // namespace promenade::study
