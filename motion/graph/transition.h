// From one capture into another without a cut ([K] 3.3): k frames in which A's window fades
// into B's, B laid over A. Feet that stand are kept in their places; a transition whose feet
// cannot be, or that is less smooth than the captures around it, says why.
#pragma once

#include <string>

#include "motion/graph/footed_take.h"
#include "motion/graph/planar_move.h"

namespace promenade::motion {

// Frame p of the transition is A_{i+p} against B_{j-k+1+p}, p = 0 .. k - 1. Both windows lie
// within their takes.
struct TransitionFrames {
  int i = 0, j = 0, k = 0;
};

// The weight of A at frame p ([K] Eq. 6, with the misprint of method.md put right): 1 at
// p = -1, 0 at p = k - 1; held outside.
double weight_of_first(int p, int k);

// Slides are the ways of the point of a foot (heel, ankle or toe) that moves least, summed over the
// steps from frame to frame in which it stands still; while it lands it slides in captures too.
// Gaps are largest second differences (seam_measures.h). Both from the frame before the transition
// to the one after it. "Inside" are gaps of the two captures as they are, from a second before
// their windows to a second after: there is a step of each foot in it.
struct TransitionQuality {
  double slide_m = 0;                        // the worse foot
  double slide_raw_m = 0;                    // the same before the feet were cleaned
  double gap_m = 0, inside_gap_m = 0;        // of a joint's place
  double knee_gap = 0, inside_knee_gap = 0;  // radians: of a knee's bend
  double moved_m = 0;                        // the most that an ankle was moved by cleaning
};

struct Transition {
  PlanarMove move;          // lays B over A: the match's, changed a little so that feet stay
  std::vector<Pose> poses;  // frames p = 0 .. k - 2, in A's place; then B_j follows, moved
  TransitionQuality quality;
  std::string refusal;  // empty: it can be used
};

struct TransitionLimits {
  double most_slide_m = 0.005;
};

// Refused is what slides further than the limit, and what has larger gaps than there are inside
// (but 0.5 mm and 0.1 degrees, which nobody sees, or people who stand still could do nothing).
// Takes share one skeleton and frame time. A take that begins with its window cannot be left by
// it, since no frame stands before it: that is refused, without poses.
Transition make_transition(const FootedTake& a, const FootedTake& b, const TransitionFrames& frames,
                           const PlanarMove& match, const TransitionLimits& limits = {});

}  // namespace promenade::motion
