// From a capture's skeleton to the body of 20 joints, and what a figure is in its
// file: which way is up, how long a unit is, where it walks. Joints are found by
// their names; where names do not tell, by the tree and by real poses of the clip
// (never by the rest pose, which need not be a pose at all).
#pragma once

#include "motion/blemishes.h"
#include "motion/body.h"
#include "motion/clip.h"

namespace promenade::motion {

struct FigureOptions {
  std::optional<double> unit_m;  // metres per file unit; guessed if not given
  std::optional<bool> z_up;      // seen from the legs if not given
};

struct Figure {
  BodyMap body;  // into the clip's skeleton
  bool z_up = false;
  double unit_m = 1;                                   // metres per file unit
  double leg_m = 0;                                    // hip to knee to ankle, metres
  Eigen::Vector2d heading = Eigen::Vector2d::UnitY();  // (x, z), Y up: where it walks, or
                                                       // faces if it stays; length 1
  int t_pose_frames = 0;       // at the front, before the motion (motion/blemishes.h)
  std::vector<Gap> gaps;       // in which it or a joint is frozen in place
  double travel_m = 0;         // of the pelvis over ground, from first to last frame
  std::vector<Problem> notes;  // warnings: what was guessed or borrowed
};

// Throws InputError when there is no body with two legs in the clip.
Figure find_figure(const Clip& clip, const FigureOptions& options = {});

// A vector of the file's axes with Y up: (x, y, z), or (x, z, -y) where Z is up.
Eigen::Matrix3d to_y_up(bool z_up);

}  // namespace promenade::motion
