// The recipe that a workshop stands for, and the set that is made of it.
#pragma once

#include <functional>

#include "motion/set_builder.h"
#include "study/workshop.h"

namespace promenade::study {

// What stands in the recipe's file. `file`: where it will lie, since the captures are found from
// there. Takes that cannot be read, and those that were left out, stand in it as no part of the
// set, so that opening it again shows them.
std::string recipe_text(const Workshop& workshop, const std::string& file);

// "results/walks.recipe.toml" for "results/walks.set".
std::string recipe_beside(const std::string& set_file);

// Writes the set that `promenade set build RECIPE --out SET` writes. `progress` is called before
// each of `steps` steps and may throw to stop it: then no set is written. Throws InputError and
// OutsideError.
motion::BuiltSet make_set(const std::string& recipe_file, const std::string& set_file,
                          const std::function<void(int step, int steps)>& progress = {});

}  // namespace promenade::study
