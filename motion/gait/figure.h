// The skeleton that walks: an adult of 1.75 m, 21 joints. Standing upright every
// joint is unturned, arms and legs hang along -Y.
#pragma once

#include "motion/body.h"

namespace promenade::motion::gait {

enum class Side { left, right };

inline constexpr double thigh_length = 0.43;  // m, hip to knee
inline constexpr double shank_length = 0.43;  // m, knee to ankle
inline constexpr double ankle_height = 0.08;  // m over the sole

// Points of the foot from the ankle, metres: where the heel and the ball touch the
// ground, the toe joint over the ball, and the tip of the toes.
inline const Eigen::Vector3d heel_point{0, -ankle_height, -0.05};
inline const Eigen::Vector3d toe_joint{0, -0.055, 0.142};
inline const Eigen::Vector3d toe_tip{0, -0.008, 0.07};  // from the toe joint

Skeleton make_skeleton();
BodyMap make_body_map(const Skeleton& skeleton);

// +1 for the left side, -1 for the right: the sign of its X.
double sign_of(Side side);

}  // namespace promenade::motion::gait
