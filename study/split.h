// A split design: each participant rates only some of the motions of a task, and all of them
// together rate every motion equally often (docs/methods.md, 14).
#pragma once

#include <vector>

#include "study/rng.h"

namespace promenade::study {

// A block of places on a circle of all motions, turned on from person to person.
struct SplitDesign {
  std::vector<int> block;   // the places of the first person, ascending
  std::vector<int> motion;  // N: which motion stands at each place
  std::vector<int> turns;   // of one round, in the order in which people get them

  int motions() const { return static_cast<int>(motion.size()); }
  int each() const { return static_cast<int>(block.size()); }
};

// 1 <= each <= motions. The block is chosen by a seeded search so that two motions meet in one
// session as evenly as turning one block allows: the same on every machine.
SplitDesign make_split(int motions, int each, Rng& rng);

// After so many people in a row, from any multiple of it on, every motion was rated equally often.
int round_of_ratings(const SplitDesign& split);
// After so many all turns were there once, and pairs of motions are as even as they get.
int round_of_pairs(const SplitDesign& split);

// The motions of the person with this order, from 0: in the order of the block.
std::vector<int> motions_of(const SplitDesign& split, int sequence);

// Which of these come a second time, so many of them: over a round of pairs every motion does so
// equally often.
std::vector<int> repeated_of(const SplitDesign& split, int repeats, int sequence);

}  // namespace promenade::study
