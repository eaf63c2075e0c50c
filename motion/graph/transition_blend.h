// The frames of a transition while it is made. Used by the files of transitions only.
//
// Frames are counted from the one before the transition here: q = p + 1, so that q = 0 is A_{i-1}
// as it is, and q = k is B_j, moved.
#pragma once

#include "motion/graph/footed_take.h"
#include "motion/graph/transition.h"

namespace promenade::motion {

struct Blend {
  const FootedTake& a;
  const FootedTake& b;
  TransitionFrames frames;
  PlanarMove move;                 // lays B over A
  std::vector<double> share;       // k + 1: of B, 0 to 1
  KneeAxes knees;                  // means of both
  std::vector<Pose> poses;         // k + 1, where A is
  std::vector<WorldPose> figures;  // k + 1: what they look like, the pelvis at the origin, unturned

  const Skeleton& skeleton() const { return a.take.skeleton; }
  const BodyMap& body() const { return a.take.body; }
  int last() const { return frames.k; }
  Eigen::Vector3d place(int q, BodyJoint part) const {
    const auto f = static_cast<std::size_t>(q);
    return poses[f].root + poses[f].rotations[0] * figures[f].positions.col(body().joint[part]);
  }
};

// A_{i-1} and the frames behind it that the transition needs are there.
Blend make_blend(const FootedTake& a, const FootedTake& b, const TransitionFrames& frames,
                 const PlanarMove& move);

// What a figure looks like in the world.
WorldPose placed(const Pose& pose, const WorldPose& figure);

// Looks at the pose of a frame again, after it was changed.
void look(Blend& blend, int q);

// Lays B elsewhere: only where the pelvis is, and how it is turned, depends on that.
void lay(Blend& blend, const PlanarMove& move);

}  // namespace promenade::motion
