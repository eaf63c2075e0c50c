// From captures to a motion set: the best loops of every take, cut, cleaned and
// named. The result depends neither on the order of the takes nor on the machine.
#pragma once

#include <functional>

#include "motion/cycle_search.h"
#include "motion/foot_plant.h"

namespace promenade::motion {

struct SetOptions {
  std::string name, credit;
  int cycles_per_take = 1;
  int phases = 60;
  double most_loop_error_m = 0.15;  // loops that close worse are refused
  FigureOptions figure;
};

// A capture to be read, and what it is called.
struct TakeSource {
  std::string file;   // to open; takes are handled in the order of these names
  std::string label;  // as the set names it
  std::string style;
};

// What became of one cycle, or why a take gave none.
struct CycleReport {
  std::string file, cycle;  // name of the cycle, empty if refused
  std::string refusal;
  Seam seam;
  double slide_left_m = 0, slide_right_m = 0;
  PlantReport plant;
  double from_capture_m = 0;  // the most that a joint was moved by closing and planting
};

struct BuiltSet {
  MotionSet set;
  std::vector<CycleReport> reports;
  std::vector<Problem> warnings;
};

// `progress` is called before each take. Throws InputError with all problems of all
// files when one cannot be read, or when no take gives a cycle.
BuiltSet build_set(std::vector<TakeSource> sources, const SetOptions& options,
                   const std::function<void(const TakeSource&)>& progress = {});

}  // namespace promenade::motion
