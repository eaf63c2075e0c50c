#include "motion/graph/transition_blend.h"

#include <utility>

namespace promenade::motion {
namespace {

const Pose& pose_of(const FootedTake& footed, int frame) {
  return footed.take.poses[static_cast<std::size_t>(frame)];
}

// A pose that stands at the origin and faces as its skeleton does.
Pose unplaced(Pose pose) {
  pose.root.setZero();
  pose.rotations[0].setIdentity();
  return pose;
}

}  // namespace

Blend make_blend(const FootedTake& a, const FootedTake& b, const TransitionFrames& frames,
                 const PlanarMove& move) {
  Blend blend{a, b, frames, move, {}, {}, {}, {}};
  for (std::size_t foot = 0; foot < 2; ++foot) {
    blend.knees[foot] = (a.legs[foot].knee + b.legs[foot].knee).normalized();
  }
  const auto count = static_cast<std::size_t>(frames.k) + 1;
  blend.poses.reserve(count);
  blend.figures.resize(count);
  for (int q = 0; q <= frames.k; ++q) {
    const double share = 1 - weight_of_first(q - 1, frames.k);
    blend.share.push_back(share);
    if (q == 0) {
      blend.poses.push_back(pose_of(a, frames.i - 1));
    } else if (q == frames.k) {
      blend.poses.push_back(pose_of(b, frames.j));
    } else {
      blend.poses.push_back(
          mix(pose_of(a, frames.i - 1 + q), pose_of(b, frames.j - frames.k + q), share));
    }
    look(blend, q);
  }
  lay(blend, move);
  return blend;
}

WorldPose placed(const Pose& pose, const WorldPose& figure) {
  const Eigen::Quaterniond& turn = pose.rotations[0];
  WorldPose world;
  world.positions = (turn.toRotationMatrix() * figure.positions).colwise() + pose.root;
  world.rotations.reserve(figure.rotations.size());
  for (const Eigen::Quaterniond& own : figure.rotations) world.rotations.push_back(turn * own);
  return world;
}

void look(Blend& blend, int q) {
  const auto f = static_cast<std::size_t>(q);
  forward_kinematics(blend.skeleton(), unplaced(blend.poses[f]), blend.figures[f]);
}

void lay(Blend& blend, const PlanarMove& move) {
  blend.move = move;
  const Eigen::Quaterniond turn = move.rotation();
  for (int q = 1; q <= blend.frames.k; ++q) {
    const auto f = static_cast<std::size_t>(q);
    const Pose& from = pose_of(blend.a, blend.frames.i - 1 + q);
    const Pose& to = pose_of(blend.b, blend.frames.j - blend.frames.k + q);
    const double share = blend.share[f];
    blend.poses[f].root = (1 - share) * from.root + share * moved(move, to.root);
    blend.poses[f].rotations[0] = from.rotations[0].slerp(share, turn * to.rotations[0]);
  }
}

}  // namespace promenade::motion
