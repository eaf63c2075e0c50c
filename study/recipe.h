// A recipe: which captures become a motion set, and how. One TOML file; docs/study-file.md
// lists every key.
//
//   name = "bandai-namco"
//   credit = "who made the captures, under which terms"
//   folder = "captures"                  # relative to the recipe
//   files = "walk_{style}_*.bvh"         # {style} names the style, * is anything
//
//   [[take]]                             # instead of `files`, or to say more about a file
//   file = "07/07_01.bvh"
//   style = "normal"
//   from = 30
//
//   [[take]]                             # known, but no part of the set
//   file = "07/07_02.bvh"
//   use = false
#pragma once

#include "motion/set_builder.h"
#include "study/file_pattern.h"

namespace promenade::study {

struct Recipe {
  motion::SetOptions options;
  std::vector<motion::TakeSource> takes;     // sorted by label
  std::vector<motion::TakeSource> left_out;  // `use = false`, in the order of the file
  std::string folder;                        // where the captures lie
};

// Reads a recipe and looks for its files. `folder` (relative to where the program runs)
// takes the place of the recipe's own if it is not empty. Throws InputError with all
// problems and their places.
Recipe load_recipe(const std::string& file, const std::string& folder = {});

// Fills in the SHA-256 of every take's file; `progress` is called before each. Throws
// InputError with all that cannot be read.
void hash_takes(Recipe& recipe, const std::function<void()>& progress = {});

}  // namespace promenade::study
