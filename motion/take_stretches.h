// What a take does besides walking, for people who look for its loops: where it turns, stands, and
// where something was lost.
#pragma once

#include <vector>

#include "motion/blemishes.h"
#include "motion/take.h"

namespace promenade::motion {

// In frames of the take and their order; stretches of one kind do not touch each other.
struct TakeStretches {
  std::vector<FrameRange> turning;   // by more than half a radian in a second, while it walks
  std::vector<FrameRange> standing;  // the pelvis goes less than a fifth of a leg in a second
  std::vector<FrameRange> jumps;     // from the first frame to the last one a joint leaps
};

TakeStretches find_stretches(const Take& take);

// Gaps of the file within the take: in its frames, those that touch each other as one.
std::vector<FrameRange> gaps_within(const Take& take, const std::vector<Gap>& gaps);

// How many frames they have together.
int frames_in(const std::vector<FrameRange>& stretches);

}  // namespace promenade::motion
