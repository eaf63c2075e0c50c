// A capture that somebody asks for, and how it is read: by the names of its file, of its take
// and of its style, with the frames that are wanted.
#pragma once

#include "motion/load_clip.h"
#include "motion/place.h"
#include "motion/take.h"

namespace promenade::motion {

// A cycle that somebody chose, in frames of the file: first, between, last.
struct GivenCycle {
  std::string name;            // empty: the style and a number
  std::vector<double> frames;  // as many as the set has key phases
  Place place = {};            // in the recipe
};

// A capture to be read, and what it is called.
struct TakeSource {
  std::string file;   // to open; takes are handled in the order of their labels
  std::string label;  // as the set names it
  std::string style;
  std::string sha256 = {};              // of the file, for the set's records
  std::optional<int> from = {};         // frames that are used, both included, counted from 0
  std::optional<int> to = {};           // beyond the end: to the end
  LoadOptions load = {};                // skeleton and frame rate of an .amc
  FigureOptions figure = {};            // where given, instead of the set's
  std::vector<GivenCycle> cycles = {};  // none: they are found
  Place place = {};                     // in the recipe
};

// What is wrong with a file, said at the place of the recipe that asked for it.
Problem asked_at(const std::string& recipe, const Place& place, const TakeSource& source,
                 const std::string& message);

// What holds for all takes of one recipe.
struct ReadOptions {
  std::string recipe;    // the file that asks for takes, for messages; may be empty
  FigureOptions figure;  // where a take has none of its own
};

struct ReadTake {
  Take take;  // the frames that are wanted
  Figure figure;
  std::vector<Problem> warnings;
};

// Throws InputError.
ReadTake read_take(const TakeSource& source, const ReadOptions& options);

}  // namespace promenade::motion
