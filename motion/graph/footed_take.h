// A take with all that transitions ask of it again and again: when its feet stand, what its legs
// are like, and how smooth it is by itself.
#pragma once

#include "motion/foot_contacts.h"
#include "motion/graph/seam_measures.h"

namespace promenade::motion {

struct FootedLeg {
  Eigen::Vector3d knee;  // the axis that it bends about
  Heel heel;
  // T: how far a frame is inside of a stance, in frames from its nearer end; negative outside.
  // At most a tenth of a second either way; a stance cut by an end of the take has no end there.
  std::vector<double> standing;
};

struct FootedTake {
  const Take& take;               // outlives this
  std::array<FootedLeg, 2> legs;  // left, right
  std::vector<FrameGap> gaps;     // T
};

FootedTake make_footed(const Take& take);
FootedTake make_footed(const Take& take, const FootContacts& contacts);

}  // namespace promenade::motion
