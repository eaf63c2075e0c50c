// Inverse kinematics of a leg of two bones and a knee that bends one way.
#pragma once

#include <Eigen/Geometry>

namespace promenade::motion::gait {

struct LegTurns {
  Eigen::Quaterniond thigh, shank;  // in the world
};

// `ahead` is where the knee points; the ankle is within reach of the hip.
LegTurns leg_turns(const Eigen::Vector3d& hip, const Eigen::Vector3d& ankle,
                   const Eigen::Vector3d& ahead);

}  // namespace promenade::motion::gait
