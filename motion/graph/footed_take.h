// A take with all that transitions ask of it again and again: when its feet stand, what its legs
// are like, and how smooth it is by itself.
#pragma once

#include "motion/foot_contacts.h"
#include "motion/graph/seam_measures.h"

namespace promenade::motion {

// What a foot stands by.
enum class Support : unsigned char { heel, ankle, toe };

// Where these are over the ground: x, z; in their order.
using Ground = Eigen::Matrix<double, 2, 3>;
Ground ground_under(const Heel& heel, const Eigen::Vector3d& ankle, const Eigen::Vector3d& toe);

// Of a step from frame to frame: what moved least; but the toe if it moved no more than `slack`
// beyond that, metres, since a foot that is flat goes on to stand by its toe.
Support support_of(const Ground& step, double slack);

// The most that a frame is inside of a stance, or outside.
inline constexpr double most_inside_seconds = 0.1;

struct FootedLeg {
  Eigen::Vector3d knee;  // the axis that it bends about
  Heel heel;
  // T: how far a frame is inside of a stance, in frames from its nearer end; negative outside.
  // A stance cut by an end of the take has no end there.
  std::vector<double> standing;
  std::vector<double> still;     // the same without the time in which it lands
  std::vector<Support> support;  // T - 1: from a frame to the next
  Eigen::Matrix2Xd steps;        // 2 x (T - 1): how that moves, metres (x, z)
};

struct FootedTake {
  const Take& take;               // outlives this
  std::array<FootedLeg, 2> legs;  // left, right
  std::vector<FrameGap> gaps;     // T
};

FootedTake make_footed(const Take& take);  // finds the contacts
FootedTake make_footed(const Take& take, const FootContacts& contacts);

}  // namespace promenade::motion
