// A capture as a walking figure: metres, Y up, the pelvis as joint 0. What stands
// above the pelvis in the file is folded into it, what does not hang from it is
// left out, and bones get the mean length that they have in the capture.
#pragma once

#include "motion/body_mapping.h"

namespace promenade::motion {

struct Take {
  std::string source;  // name of the file
  Skeleton skeleton;
  BodyMap body;
  double frame_time = 0;    // seconds
  std::vector<Pose> poses;  // T
  int first_frame = 0;      // of the file: where the take begins
  int period = 0;           // frames after which the file began again; 0: never

  int frames() const { return static_cast<int>(poses.size()); }
};

Take make_take(const Clip& clip, const Figure& figure);

// The frames `from` to `to` of a take, both included and within it.
Take part(const Take& take, int from, int to);

// The pose at a frame and between frames, smooth in velocity. Held at both ends.
Pose pose_at(const Take& take, double frame);

// Where the pelvis and the other joints of the body are at that frame, metres.
Eigen::Matrix<double, 3, body_joint_count> body_at(const Take& take, double frame);

// The way of the pelvis over the ground: 2 x T (x, z), metres.
Eigen::Matrix2Xd pelvis_way(const Take& take);

// A pose between two, the short way.
Pose mix(const Pose& a, const Pose& b, double share);

}  // namespace promenade::motion
