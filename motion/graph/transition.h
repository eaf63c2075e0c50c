// From one capture into another without a cut ([K] 3.3): k frames in which A's window fades
// into B's, B laid over A. Feet that stand are kept in their places; a transition whose feet
// cannot be, says why.
#pragma once

#include <span>

#include "motion/foot_contacts.h"
#include "motion/graph/planar_move.h"

namespace promenade::motion {

// Frame p of the transition is A_{i+p} against B_{j-k+1+p}.
struct TransitionFrames {
  int i = 0, j = 0, k = 0;
};

// The weight of A at frame p ([K] Eq. 6, with the misprint of method.md put right): 1 at
// p = -1, 0 at p = k - 1.
double weight_of_first(int p, int k);

struct TransitionQuality {
  double slide_m = 0;       // the way of the supporting point of a foot that stands, the worse foot
  double slide_raw_m = 0;   // the same before the feet were cleaned
  double gap_m = 0;         // largest second difference of a joint's place, seams included
  double inside_gap_m = 0;  // the largest of the two captures near the windows, for comparison
  double knee_gap = 0;      // radians: largest second difference of a knee's bend
  double inside_knee_gap = 0;  // and of the captures near the windows
  double moved_m = 0;          // the most that an ankle was moved by cleaning
};

struct Transition {
  PlanarMove move;          // lays B over A: the match's, moved a little so that feet stay
  std::vector<Pose> poses;  // frames p = 0 .. k - 2, in A's place; then B_j follows, moved
  TransitionQuality quality;
  std::string refusal;  // empty: it can be used
};

struct TransitionLimits {
  double most_slide_m = 0.005;
};

// A take and what its transitions need to know of it, worked out once. The take must outlive
// it; takes share one skeleton and frame time.
struct FootedTake {
  const Take* take;
  FootContacts contacts;
};
FootedTake make_footed(const Take& take);

Transition make_transition(const FootedTake& a, const FootedTake& b, const TransitionFrames& frames,
                           const PlanarMove& match, const TransitionLimits& limits = {});

}  // namespace promenade::motion
