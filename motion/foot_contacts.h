// When a foot stands: while its ankle or its toe is low and nearly still. What is
// "nearly" follows the take: a share of the speed of its swinging feet, raised
// until the feet overlap as they do in walking.
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
