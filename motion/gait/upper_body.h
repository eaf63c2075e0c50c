// Trunk, head and arms, as they are turned in the world.
#pragma once

#include <Eigen/Geometry>

#include "motion/gait/figure.h"
#include "motion/gait/style.h"

namespace promenade::motion::gait {

struct TrunkTurns {
  Eigen::Quaterniond spine, chest, neck, head;
};

struct ArmTurns {
  Eigen::Quaterniond clavicle, upper, fore, hand;
};

TrunkTurns trunk_turns(const GaitStyle& style, double stride);
ArmTurns arm_turns(const GaitStyle& style, Side side, double stride);

}  // namespace promenade::motion::gait
