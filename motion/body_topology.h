// Parts of the body by the tree of joints alone. Internal to the mapping.
#pragma once

#include "motion/body_names.h"

namespace promenade::motion {

bool is_below(const Skeleton& skeleton, int joint, int ancestor);  // or the same
int common_ancestor(const Skeleton& skeleton, int a, int b);

// Two legs, each hip over knee over ankle, and where they meet.
bool legs_are_whole(const Skeleton& skeleton, const NamedJoints& joints);

// The limbs by the lengths of bones (J, each to its parent): the two branches of
// equal reach below a joint with three are the legs. Which of them is left is
// not known here: "left" is the first. -1 where nothing was found.
NamedJoints joints_by_topology(const Skeleton& skeleton, const Eigen::VectorXd& bones);

}  // namespace promenade::motion
