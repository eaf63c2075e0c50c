// All loops that a take offers, from one right foot off to the next, and how well
// each closes: by the take's distance from itself, of the windows of a third of a second around
// both ends ([K] 3.1), which sees place, speed and what comes next at once.
#pragma once

#include "motion/foot_contacts.h"

namespace promenade::motion {

// Times are frames of the take. Keytimes of a walk: right off, right on, left off, left on,
// right off, each foot landing before the other leaves.
struct CycleCandidate {
  std::vector<double> keys;
  double turn = 0;          // radians about Y from the first pose to the last
  double straightness = 1;  // way of the pelvis from end to end over the way it walked
  double loop_error_m = 0;  // gap of the joints, the last pose laid over the first; RMS
  double velocity_gap = 0;  // m/s, the same of their velocities
  double window_m = 0;      // distance of the windows around both ends (motion/graph), RMS
  double score = 0;         // metres; less is better

  double first() const { return keys.front(); }
  double length() const { return keys.back() - keys.front(); }
};

struct CycleSearchOptions {
  double most_turn = 0.45;          // radians in one cycle: it will be straightened
  double most_loop_error_m = 0.15;  // cycles that close worse are refused
};

struct CycleSearch {
  std::vector<CycleCandidate> candidates;  // the best first
  std::string refusal;                     // what is wrong with the others; empty if there are none
  int refused = 0, turning = 0;            // how many others there are, and how many of them turn
};

CycleSearch find_cycles(const Take& take, const FootContacts& contacts,
                        const CycleSearchOptions& options = {});

// Loops of any motion, walk or not, where the take is like itself a while later: two keytimes each,
// first and last. Of loops that are as good the shorter comes first: twice around is a loop, too.
CycleSearch find_any_loops(const Take& take, const CycleSearchOptions& options = {});

// The best loops that do not share frames, at most `count`, in the order of time.
std::vector<CycleCandidate> best_apart(const std::vector<CycleCandidate>& all, int count);

// Why these keytimes (frames of the take) are no cycle of it: outside of the take, or not
// ascending. Empty: they are.
std::string trouble_with_keys(const Take& take, const std::vector<double>& keys);

// A cycle that somebody names by its keytimes, which must be one: how it closes.
CycleCandidate given_cycle(const Take& take, std::vector<double> keys);

// How poses at two frames differ when the second is turned about Y and moved over
// the ground onto the first.
struct PoseGap {
  double turn = 0;        // radians: by how much the second faces further left
  double position_m = 0;  // RMS over the body's joints
  double velocity_m_s = 0;
};
PoseGap pose_gap(const Take& take, double frame, double later);

// A take that is one loop already is repeated, so that cycles which run over its
// end are found. Others come back as they are.
Take unrolled(Take take);

}  // namespace promenade::motion
