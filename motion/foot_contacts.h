// When a foot stands: while its ankle or its toe is low and nearly still. What is
// "nearly" follows the take: a share of the speed of its swinging feet, raised
// until the feet overlap as they do in walking. It is down a little earlier: from when
// its heel or toe comes to the floor, though it still turns and slides a little. The floor
// is where that foot stands in that step: the floor of a capture is often not level.
// A stance ends when the ball of the foot leaves; toes, which captures rarely have, would
// leave some 0.05 s later. So captures have 2 to 10 % of double support where force
// plates show 10: a foot that moves cannot be planted.
#pragma once

#include "motion/heel.h"
#include "motion/take.h"

namespace promenade::motion {

// In frames of the take, between frames where the speed says so. Between `on` and `still` the
// foot lands: it turns about its heel and slides a little.
struct Stance {
  double on = 0, off = 0;
  double still = 0;
};

// One foot over the frames of a take (T each): the slower of ankle and toe, and how far
// it is above where it stands; the speed of the slowest of ankle, toe and heel from then on,
// and how far the lower of toe and heel is above where toes stand. m/s and metres.
struct FootCourse {
  std::vector<double> speed, height, sole_speed, sole_height;
};

struct FootContacts {
  std::vector<Stance> left, right;  // in order of time; those cut by an end of the take as well
  FootCourse left_course, right_course;
  Heel left_heel, right_heel;
  double still_m_s = 0;  // below this speed a point of the foot stands
};

FootContacts find_contacts(const Take& take);

}  // namespace promenade::motion
