// A capture as somebody looks at it who makes a motion set: what it shows, which loops it offers,
// and how a loop turns out once it is cut. What set_builder does with it, take by take.
#pragma once

#include "motion/set_builder.h"
#include "motion/take_stretches.h"

namespace promenade::motion {

enum class TakeKind { walks, turns, stands, no_walk };

struct TakeReview {
  Take take;  // as its cycles are found: one that is a loop already is repeated
  Figure figure;
  bool unit_guessed = false;
  TakeKind kind = TakeKind::no_walk;
  std::vector<Problem> warnings;
  FootContacts contacts;
  CycleSearch search;
  TakeStretches stretches;
  std::vector<FrameRange> gaps;  // frozen frames and jumps, in frames of the take

  int joints() const { return take.skeleton.size(); }
};

// Throws InputError, as build_set does, when the file cannot be read. Cycles that are given are
// not looked at.
TakeReview review_take(const TakeSource& source, const SetOptions& options);

// A loop as the set would have it, alone: on the bones of its take.
struct LoopReview {
  CycleCandidate cut;  // in frames of the take: how it closes before anything is done to it
  MotionSet set;       // of this cycle
  double slide_m = 0;  // of the standing foot that slides more, once it is planted
  double seam_m = 0;   // gap of the joints between both ends before they are closed, RMS
  double moved_m = 0;  // the most that an ankle was moved
  const Cycle& cycle() const { return set.cycles.front(); }
};

// `keys`: frames of the take for which trouble_with_keys has nothing to say, as many as the
// options have key phases.
LoopReview review_loop(const Take& take, const std::vector<double>& keys,
                       const SetOptions& options);

// The same keys with one of both ends elsewhere, as near to `frame` as keytimes that ascend
// allow; `last`: the end that is moved.
std::vector<double> with_end_at(const Take& take, std::vector<double> keys, bool last,
                                double frame);

}  // namespace promenade::motion
