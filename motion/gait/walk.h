// One style, walking: a pose for every time. Start here to understand the gait
// model: footfalls and the path of the pelvis come first (feet.h, pelvis.h), the
// legs follow by inverse kinematics (legs.h), the upper body goes along.
#pragma once

#include "motion/gait/pelvis.h"
#include "motion/skeleton.h"

namespace promenade::motion::gait {

struct Walk {
  GaitStyle style;
  Skeleton skeleton;
  PelvisHeight height{};
};

Walk make_walk(GaitStyle style);

// At a stride that counts on, on the joints of make_skeleton(). Walks along +Z.
Pose walking_pose(const Walk& walk, double stride);

// Right foot off, right foot on, left foot off, left foot on, right foot off:
// seconds from 0, which is the stride first_toe_off().
std::vector<double> walking_keytimes(const GaitStyle& style);
double first_toe_off(const GaitStyle& style);

}  // namespace promenade::motion::gait
