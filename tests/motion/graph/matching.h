// Windows that are alike, found by trying all: for tests of what comes after.
#pragma once

#include "motion/graph/transition.h"
#include "motion/graph/window_distance.h"

namespace promenade::motion {

// A take with what graphs ask of it.
struct Matchable {
  explicit Matchable(const Take& take)
      : footed(make_footed(take)),
        clouds(joint_clouds(take, joint_weights(take.skeleton, take.body))) {}

  FootedTake footed;
  Clouds clouds;
};

struct FoundMatch {
  TransitionFrames frames;
  WindowDistance distance;
};

// The frame of B, `first` to `last`, whose window is most like A's from frame i on.
inline FoundMatch best_match(const Matchable& a, int i, const Matchable& b, int first, int last,
                             int k) {
  const std::vector<double> taper(static_cast<std::size_t>(k), 1.0 / k);
  FoundMatch best{{i, 0, k}, {INFINITY, 1, {}}};
  for (int j = first; j <= last; ++j) {
    const WindowDistance distance = window_distance(a.clouds, i, b.clouds, j, taper);
    if (distance.rms() < best.distance.rms()) best = {{i, j, k}, distance};
  }
  return best;
}

inline Transition transition_of(const Matchable& a, const Matchable& b, const FoundMatch& match) {
  return make_transition(a.footed, b.footed, match.frames, match.distance.move);
}

}  // namespace promenade::motion
