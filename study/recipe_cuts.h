// The table [cuts] of a recipe: a CSV file beside the captures that says which frames of
// each are good, one row for each style, such as Frame_Cuts.csv of 100STYLE.
#pragma once

#include <filesystem>

#include "motion/set_builder.h"
#include "study/toml_reader.h"

namespace promenade::study {

// Fills in `from` and `to` of the takes that do not say them. Everything that is wrong is
// added to the reader of the recipe.
void apply_cuts(const TomlTable& cuts, const std::filesystem::path& folder,
                std::vector<motion::TakeSource>& takes);

}  // namespace promenade::study
