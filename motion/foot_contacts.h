// When a foot stands: while its ankle or its toe is low and nearly still. What is
// "nearly" follows the take: a share of the speed of its swinging feet, raised
// until the feet overlap as they do in walking. It is down a little earlier: from when
// its heel or toe comes to the floor, though it still turns and slides a little. Real
// captures then have 5 % of double support each and 55 % of stance, where normal gait
// has 10 and 60: their feet slow down late and speed up early, and a foot that moves
// cannot be planted.
#pragma once

#include "motion/take.h"

namespace promenade::motion {

// In frames of the take, between frames where the speed says so.
struct Stance {
  double on = 0, off = 0;
};

struct FootContacts {
  std::vector<Stance> left, right;  // in order of time; those cut by an end of the take as well
  double still_m_s = 0;             // below this speed a point of the foot stands
};

FootContacts find_contacts(const Take& take);

}  // namespace promenade::motion
