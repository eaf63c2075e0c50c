// From captures to a motion set: the best loops of every take, cut, cleaned and
// named. The result depends neither on the order of the takes nor on the machine.
#pragma once

#include <functional>

#include "motion/cycle_search.h"
#include "motion/foot_measures.h"
#include "motion/foot_plant.h"
#include "motion/take_source.h"

namespace promenade::motion {

struct SetOptions {
  std::string name, credit;
  int cycles_per_take = 1;
  int phases = 60;
  CycleSearchOptions search;
  FigureOptions figure;
  std::string recipe;    // the file that asks for takes and cycles, for messages; may be empty
  std::string skeleton;  // label of the take whose bones the set has; empty: the mean of all
  bool walk = true;      // false: cycles are given, or loops of any kind; feet stay as they are
  std::vector<double> key_phases = {0, 0.4, 0.5, 0.9, 1};
  bool keep_takes = false;  // for pictures: BuiltSet::takes
};

// A take as pictures show it.
struct TakeRecord {
  std::string file;
  double frame_time = 0;
  int first_frame = 0;  // of the file: where frame 0 of what follows is
  int period = 0;       // of a take that is one loop: it was repeated; else 0
  FootContacts contacts;
  std::vector<CycleCandidate> cycles;  // that were found
};

// What became of one cycle, or why a take gave none.
struct CycleReport {
  std::string file, cycle = {};  // name of the cycle, empty if refused
  std::string refusal = {};
  Seam seam = {};
  double slide_left_m = 0, slide_right_m = 0;
  PlantReport plant = {};
  double from_capture_m = 0;  // the most that a joint was moved by closing and planting
  int take = -1;              // in BuiltSet::takes
  CycleCandidate cut = {};    // in the take's frames
  // 3 x 20, metres: the body at the first and the last frame, both over the origin and
  // facing along +Z, and at the seam as the set has it.
  using Body = Eigen::Matrix<double, 3, body_joint_count>;
  Body first = Body::Zero(), last = Body::Zero(), closed = Body::Zero();
};

struct BuiltSet {
  MotionSet set;
  std::vector<CycleReport> reports;
  std::vector<TakeRecord> takes;  // in the order of their labels, when asked for
  std::vector<Problem> warnings;
};

// `progress` is called before each take is read. Throws InputError with all problems of all
// files when one cannot be read or has no such cycle, or when no take gives a cycle.
BuiltSet build_set(std::vector<TakeSource> sources, const SetOptions& options,
                   const std::function<void(const TakeSource&)>& progress = {});

}  // namespace promenade::motion
