#include "study/assignment.h"

#include <algorithm>
#include <cassert>
#include <set>
#include <tuple>

namespace promenade::study {
namespace {

using State = GivenOrder::State;

class Deficits {
 public:
  Deficits(const std::vector<GivenOrder>& given, DesignRound round)
      : round_(round),
        in_cell_(static_cast<std::size_t>(round.cells), 0),
        in_row_(static_cast<std::size_t>(round.rows), 0) {
    for (const GivenOrder& one : given) {
      if (one.state == State::gone || one.sequence < 0) continue;
      held_.insert(one.sequence);
      if (one.state != State::interrupted) count(one.sequence);
    }
    for (int cell = 0; cell < round.cells; ++cell) next_.push_back(free_from(cell));
  }

  int take() {
    int best = 0;
    for (int cell = 1; cell < round_.cells; ++cell) {
      if (rank(cell) < rank(best)) best = cell;
    }
    int& next = next_[static_cast<std::size_t>(best)];
    const int sequence = next;
    count(sequence);
    next = free_from(sequence + round_.cells);
    return sequence;
  }

 private:
  std::tuple<int, int, int> rank(int cell) const {
    return {in_cell_[static_cast<std::size_t>(cell)],
            in_row_[static_cast<std::size_t>(cell % round_.rows)],
            next_[static_cast<std::size_t>(cell)]};
  }

  void count(int sequence) {
    ++in_cell_[static_cast<std::size_t>(sequence % round_.cells)];
    ++in_row_[static_cast<std::size_t>(sequence % round_.rows)];
  }

  // The lowest number of this cell, from `sequence` on, that nobody holds.
  int free_from(int sequence) const {
    while (held_.count(sequence) > 0) sequence += round_.cells;
    return sequence;
  }

  DesignRound round_;
  std::set<int> held_;
  std::vector<int> in_cell_, in_row_, next_;
};

}  // namespace

DesignRound round_of(const Study& study) { return {rows_of_design(study), cells_of_design(study)}; }

std::vector<int> next_orders(const std::vector<GivenOrder>& given, DesignRound round, int count) {
  assert(round.rows > 0 && round.cells % round.rows == 0 && "a round has whole designs");
  Deficits deficits(given, round);
  std::vector<int> sequences;
  for (int i = 0; i < count; ++i) sequences.push_back(deficits.take());
  return sequences;
}

}  // namespace promenade::study
