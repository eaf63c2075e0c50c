// Which order the next person gets: the one that is most missing among the people who count
// (docs/methods.md, 3). A pure rule; study/store.h asks it for the sessions of one kind, real,
// pilot or simulated.
#pragma once

#include <vector>

#include "study/plan.h"

namespace promenade::study {

// A session that was given an order, and what became of it.
struct GivenOrder {
  enum class State {
    counts,       // finished, and not taken out again
    runs,         // now, in some process: expected to count
    interrupted,  // can be gone on with: its number stays its own, its order is missing
    gone          // declined, stopped, withdrawn or excluded: as if it had never been
  };
  int sequence = 0;
  State state = State::counts;
};

// After `cells` sequences all that is balanced begins again (cells_of_design); sequences that
// are equal modulo `rows` have one order of the interfaces (plan.h).
struct DesignRound {
  int rows = 1, cells = 1;
};
DesignRound round_of(const Study& study);

// Sequences for the next `count` people, if all of them count. Each time the cell of the design
// with the fewest who count or run comes first, of equals the one whose row has the fewest, of
// equals the lowest number. No number is given that somebody holds who counts, runs or was
// interrupted: so shuffles and draws, which follow from the number, stay different.
std::vector<int> next_orders(const std::vector<GivenOrder>& given, DesignRound round, int count);

}  // namespace promenade::study
