// The 51 motion features of a cycle ([O] 5; docs/methods.md, 9): sigma is the standard
// deviation and mu the mean over the time of the cycle, of the angle of a body part
// or of the centre of mass in the heading frame of the cycle (ahead +Z, left +X).
//
// Angles in degrees: a limb's unit vector, proximal to distal, by atan2(ahead, down)
// or atan2(left, down), so that hanging is 0; torso and head by atan2(., up). They are
// followed around the circle, so an arm raised over 180 degrees does not jump; the mean
// lies in (-180, 180]. The torso runs from mid-hip to mid-shoulder, the head from the
// neck to its top, the foot from ankle to toe. Positions in metres, with the mean
// travel of the pelvis taken out; velocities in m/s, the travel included. Step length:
// from the left to the right ankle when the right foot comes on, ahead; and from the
// right to the left one across, so that both are positive in a normal walk.
#pragma once

#include <span>
#include <string_view>

#include "motion/motion_set.h"

namespace promenade::motion {

inline constexpr int feature_count = 51;  // 25 sigma, 23 mu, 3 v

// "sigma_left-foot_left-right" and so on; the names of the source, and one of ours.
std::span<const std::string_view> feature_names();

// The index of a name, or -1.
int find_feature(std::string_view name);

// 51 values of a cycle, in the order of the names.
Eigen::VectorXd motion_features(const MotionSet& set, const Cycle& cycle);

// 51 x N, one column a cycle.
Eigen::MatrixXd motion_features(const MotionSet& set);

// The unit of a feature: "deg", "m", "m/s" or "s".
std::string_view feature_unit(int feature);

}  // namespace promenade::motion
