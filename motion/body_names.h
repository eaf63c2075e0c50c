// Which part of the body a joint is, by its name, in the conventions that we
// have met: UpperLeg_L, LeftUpLeg, lfemur, RightHip, mixamorig:LeftArm,
// "Skeleton 001:LThigh", Bip01 L Calf.
#pragma once

#include <optional>
#include <string_view>

#include "motion/body.h"

namespace promenade::motion {

// Hips or pelvis, of any spelling.
bool names_the_hips(std::string_view name);

// The joints that have names of their own; -1 where none was found. The chest and
// the pelvis are not among them: they follow from the tree.
using NamedJoints = std::array<int, body_joint_count>;
NamedJoints joints_by_name(const Skeleton& skeleton);

}  // namespace promenade::motion
