// Does it matter when an interface came? Turns, learning over them, carry-over, and how well the
// orders of those analysed are balanced. A turn is the place of an interface among those that a
// person had in one task, from 1, by first appearance; practice does not count.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "analysis/comparisons.h"
#include "analysis/statistics/moments.h"
#include "analysis/statistics/sign_test.h"

namespace promenade::analysis {

// The values of all people at one turn, whatever the interface was.
struct TurnSummary {
  int measure = 0, task = 0;
  int turn = 0;  // from 1
  Moments moments;
  std::optional<double> median;
};

// Per person the slope of the least-squares line of value against turn, of two turns the second
// value minus the first; then tests of these slopes against zero. Interfaces differ too: only
// where the orders are balanced does the slope speak of turns alone.
struct Learning {
  int measure = 0, task = 0;
  std::vector<double> slopes;             // of people with values at two turns or more
  SignedRankTest test;                    // zeros dropped, exact
  std::optional<double> p;                // exact; normal where exact is not feasible
  SignTest sign;                          // of the slopes that are not zero
  std::optional<double> hl;               // change per turn, in the unit of the measure
  std::optional<LocationInterval> hl_ci;  // 95 %
};

// One interface after another one, or at first.
struct CarryOver {
  int measure = 0, task = 0, interface = 0;
  int previous = -1;  // of Trial::previous_interface; -1: it was the first
  Moments moments;    // one value per person
};

struct TurnCount {
  int task = 0, interface = 0;
  std::vector<int> at_turn;  // people who had it first, second, ...
};
struct SuccessionCount {
  int task = 0, previous = 0, interface = 0;
  int people = 0;  // who had `interface` right after `previous`
};

struct OrderEffects {
  std::vector<TurnSummary> turns;
  std::vector<Learning> learning;
  std::vector<CarryOver> carry_over;
  std::vector<TurnCount> turn_counts;
  std::vector<SuccessionCount> successions;
  std::vector<std::string> sentences;  // on the balance, task by task
};

// Of final and best D, time and ratings.
OrderEffects order_effects_of(const Log& log, const Dataset& data);

}  // namespace promenade::analysis
