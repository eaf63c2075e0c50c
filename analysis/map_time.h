// Where on the map people spent their time: what they were shown, from table `sample` of the
// databases, on the plane and the cells that `map_coverage` counts (study/process_measures.h),
// whatever the interface.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "analysis/dataset.h"
#include "motion/models/ward.h"
#include "study/process_measures.h"

namespace promenade::study {
struct StudyBundle;
}  // namespace promenade::study

namespace promenade::analysis {

inline constexpr int map_cells = 10;  // along each side, as CoverageMap::cell_of counts them

// All trials of a task with one interface.
struct MapTime {
  int task = 0, interface = 0;
  int trials = 0;
  std::array<double, map_cells * map_cells> seconds{};  // by CoverageMap::cell_of
  double outside_s = 0;                                 // beyond the edge

  double total_s() const;
};

struct MapTimes {
  std::vector<MapTime> times;      // by task, then interface; without those that show nothing
  std::vector<std::string> names;  // of the examples, and where they are
  study::CoverageMap map;
  motion::Dendrogram tree;  // of the examples: Ward, of all that shapes the map
  int paused = 0;           // trials left out because they stood still or were interrupted
  int other_set = 0;        // trials left out because another version had another motion set
  std::string missing;      // why there is nothing: a sentence; empty: nobody asked, or it is there
};

// What was shown from a moment of a trial on, until the next one.
struct Shown {
  std::int64_t t_us = 0;
  int cell = 0;  // -1: beyond the edge
};

// Each moment lasts until the next, the last one until `ended_us`.
void add_time(const std::vector<Shown>& shown, std::int64_t ended_us, MapTime& time);

// With the motions of the study as a database holds it; null: it cannot be read. Opens the
// databases of the log again, read-only. Throws InputError when they are gone.
MapTimes map_times(const Log& log, const Dataset& data, const study::StudyBundle* stored);

}  // namespace promenade::analysis
