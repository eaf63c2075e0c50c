// A recipe: which captures become a motion set, and how. One TOML file:
//
//   name = "bandai-namco"
//   credit = "who made the captures, under which terms"
//   folder = "captures"                  # relative to the recipe
//   files = "walk_{style}_*.bvh"         # {style} names the style, * is anything
//   cycles_per_take = 1                  # 1 to 20
//   most_loop_error_m = 0.15             # loops that close worse are refused
//   unit_m = 0.01                        # metres per file unit; guessed if left out
//   up = "y"                             # "y" or "z"; seen from the legs if left out
#pragma once

#include "motion/set_builder.h"

namespace promenade::study {

struct Recipe {
  motion::SetOptions options;
  std::vector<motion::TakeSource> takes;  // sorted by file name
};

// Reads a recipe and looks for its files. `folder` (relative to where the program runs)
// takes the place of the recipe's own if it is not empty. Throws InputError with all
// problems and their places.
Recipe load_recipe(const std::string& file, const std::string& folder = {});

// Does the name of a file fit the pattern? Then its style: what {style} stands for, or
// the whole name without its ending if the pattern has no {style}.
std::optional<std::string> style_of(const std::string& file_name, const std::string& pattern);

}  // namespace promenade::study
