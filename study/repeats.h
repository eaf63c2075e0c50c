// Motions that come a second time in a rate task, so that people can be held against themselves
// (docs/methods.md, 14).
#pragma once

#include <vector>

namespace promenade::study {

constexpr int least_between = 3;  // motions between the two showings of one, where possible

// One trial of a rate task.
struct Showing {
  int target = 0;   // index into Task::targets
  int showing = 1;  // 2: it comes again
};

// `order`: the motions of a person as they come; `again`: which of them come a second time. Those
// stand in the last part, one after each of the last new ones, so that nobody can tell where the
// repeats begin. Where `fixed` is not set, motions change their places for that.
std::vector<Showing> with_repeats(std::vector<int> order, const std::vector<int>& again,
                                  bool fixed);

}  // namespace promenade::study
