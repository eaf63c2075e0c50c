// What recording programs leave in a capture: a T-pose before the motion, and gaps in
// which what was lost stands still. All of this is ours.
#pragma once

#include "motion/body.h"
#include "motion/clip.h"

namespace promenade::motion {

struct FrameRange {
  int first = 0, last = 0;  // both belong to it
};

// Frames at the front in which the figure is not in motion yet: no joint is turned (the
// rest pose of the file), or it has straight arms held out to its sides and either stands
// so for a quarter of a second or leaps out of it as no body can. 0: none, or the whole
// clip is so.
int frames_in_t_pose(const Clip& clip, const BodyMap& body, bool z_up);

// Where values repeat to the last digit, which no body does: at least four frames of the
// whole figure (joint -1), or ten of a joint that turns about three axes, seldom repeats
// elsewhere and does not come back to that position. In the order of joints and frames. A
// clip without motion has no gaps.
struct Gap {
  int joint = -1;
  FrameRange frames;
};
std::vector<Gap> find_gaps(const Clip& clip);

// The same in words, for the user.
std::vector<Problem> describe_blemishes(const Clip& clip, int t_pose_frames,
                                        const std::vector<Gap>& gaps);

}  // namespace promenade::motion
