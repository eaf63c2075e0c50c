// One skeleton for all takes of a set. A take with the same joints and other bones fits:
// its rotations are kept, its travel is scaled by the length of its legs when a cycle is
// cut, and its feet are planted anew.
#pragma once

#include "motion/take.h"

namespace promenade::motion {

struct SharedSkeleton {
  Skeleton skeleton;
  BodyMap body;
};

// The skeleton that most takes have (of several the first such), its offsets with their
// mean over these takes. Bones of `model` alone if it is not negative. At least one take.
SharedSkeleton shared_skeleton(const std::vector<Take>& takes, int model = -1);

// A take whose joints are those of the shared skeleton in its order, its bones still its
// own; or why it cannot be one, by the names of what is missing.
struct Fitted {
  Take take;
  std::string refusal;            // empty: it fits
  std::vector<std::string> lent;  // joints beyond the body that it lacks: they stay unturned
};
Fitted fit_to(const SharedSkeleton& shared, const Take& take);

}  // namespace promenade::motion
