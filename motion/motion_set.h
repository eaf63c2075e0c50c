// A motion set: N looping cycles on one skeleton, in the canonical form of
// docs/methods.md, 1. Start here to understand motion/.
//
// Every cycle is sampled at F common phases; between keytimes (right foot off,
// right foot on, left foot off, left foot on, right foot off) time runs
// linearly. A cycle walks along +Z; its mean planar velocity is kept apart, so
// that `root` only sways about the origin.
#pragma once

#include <string>
#include <vector>

#include "motion/body.h"

namespace promenade::motion {

// Where a cycle was cut from, and what was changed. One that was made has none of it.
struct CycleOrigin {
  std::string sha256;     // of the file, 64 hexadecimal digits; empty: not known
  double frame_time = 0;  // of the file, seconds
  int cycles_found = 0;   // loops that the take offered; 0: the recipe named this one
  double turn = 0;        // radians that it turned left from end to end, before it was straightened
  double straightness = 1;  // way from end to end over the way walked, before that; 1: straight
  double scale = 1;         // leg of the set's skeleton over that of the file's
  double moved_m = 0;       // the most that a joint was moved by closing and planting
};

struct Cycle {
  std::string name;     // unique in its set: "happy_1"
  std::string style;    // "happy"
  std::string source;   // the file it was cut from, or "generated"
  int first_frame = 0;  // in the source
  int frames = 0;       // in the source, without the closing one
  double seconds = 0;
  std::vector<double> keytimes;  // M+1, seconds from 0 to `seconds`
  Eigen::Matrix4Xd rotations;    // 4 x (F J): unit quaternion x y z w of joint j at
                                 // phase f in column f J + j, local
  Eigen::Matrix3Xd root;         // 3 x F, metres: sway of the pelvis about its mean
                                 // horizontal position, and its height over ground
  Eigen::Vector2d velocity = Eigen::Vector2d::Zero();  // mean, m/s: left (+X), ahead (+Z)
  double loop_error_m = 0;  // gap at the seam before it was closed, RMS over joints
  CycleOrigin origin;
};

struct MotionSet {
  std::string name;
  std::string credit;  // whose motions these are, and under which terms
  Skeleton skeleton;   // joint 0 is the pelvis
  BodyMap body;
  int phases = 60;                                         // F
  std::vector<double> key_phases = {0, 0.4, 0.5, 0.9, 1};  // M+1, 0 to 1
  bool walk = true;  // the keytimes are those of a walk: see above
  std::vector<Cycle> cycles;

  int size() const { return static_cast<int>(cycles.size()); }
};

int find_cycle(const MotionSet& set, const std::string& name);  // -1: none
std::vector<std::string> names_of(const MotionSet& set);        // of its cycles, in order

// Time warp of a cycle: phase (0 to 1) to seconds and back, piecewise linear
// between keytimes. Values outside wrap around by whole cycles.
double seconds_at(const MotionSet& set, const Cycle& cycle, double phase);
double phase_at(const MotionSet& set, const Cycle& cycle, double seconds);

// The pose at a phase, walking on the spot (the mean velocity left out).
Pose pose_at(const MotionSet& set, const Cycle& cycle, double phase);
// The same; `pose` keeps its memory.
void pose_at(const MotionSet& set, const Cycle& cycle, double phase, Pose& pose);

}  // namespace promenade::motion
