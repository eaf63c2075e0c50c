// The trials that count, as numbers: what the tests and figures are made of.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "analysis/log.h"
#include "analysis/selection.h"

namespace promenade::analysis {

// What a measure is about: what came out, what people said of it, or how they got there.
enum class MeasureKind { result, rating, process };

// Something measured in each trial. Its name is that of the trial column, or of
// the rating item ("answer.NAME" where that is a column, too).
struct Measure {
  std::string name;
  std::string label;  // "final distance D"
  std::string unit;   // of the values: "m", "s", "" for counts and ratings
  // How people read it: value * scale, in shown_unit, with so many decimals.
  std::string shown_unit;
  double scale = 1;
  int decimals = 1;
  MeasureKind kind = MeasureKind::result;
};

// The measures of every trial: results, then ratings by these items, then those of the process.
std::vector<Measure> measures_with(const std::vector<std::string>& rating_items);

// Why a trial is better left out of a sensitivity analysis (docs/methods.md, 6).
struct TrialQuality {
  int late_frames = 0;
  double uncertainty_ms = 0;  // the largest of the time stamps of any input
  bool interrupted = false;   // the program ended in it and went on
  bool paused = false;
  bool slow_frames = false;  // more than one late frame a second, on average
  bool coarse_time = false;  // an input whose time is known to 50 ms or worse

  bool flagged() const { return interrupted || paused || slow_frames || coarse_time; }
};

// A trial with an outcome of its own: success, timeout or done.
struct Trial {
  int person = 0;  // index into Dataset::people, and so on
  int interface = 0, task = 0, target = 0;
  int position = 0;  // in the session, from 1
  std::string outcome;
  bool failed = false;  // timeout, or done with D above the threshold (gave up)
  std::vector<std::optional<double>> values;  // one for each measure
  int logged = 0;                             // index into Log::trials
  int block = 0;                              // of the plan, from 1
  // Of the latest earlier trial of the session, practice left out, that had another interface;
  // -1: none. What a carry-over comes from.
  int previous_interface = -1;
  TrialQuality quality = {};
};

struct Task {
  std::string name;
  std::vector<std::string> targets;
  std::optional<double> limit_s, threshold_m;  // if all its trials had the same
  bool guess = false;  // what is made cannot be seen; Done below the threshold is a success
};

struct Dataset {
  std::vector<std::string> people;      // codes of those analysed
  std::vector<std::string> interfaces;  // in the order of the study
  std::vector<Task> tasks;
  // d_first, d_best, d_final, time_s, clicks, changes, ratings, then those of the process.
  std::vector<Measure> measures;
  std::vector<Trial> trials;
  bool all_simulated = false;  // there are people, and none of them is real
  std::string order;           // of the interfaces, as the study says; empty: not known
  int left_out_trials = 0;     // of these people: skipped, aborted or cut off

  int measure(std::string_view name) const;  // index; -1: none
  bool occurs(int measure, int task) const;  // has a trial of the task a value of it?
};

// Interfaces, tasks and targets stand in the order of the study file; those that it
// does not name follow in natural order. Trials of people whose disposition is
// not `analysed` are not in it.
Dataset make_dataset(const Log& log, const Selection& selection);

// The values that are there.
std::vector<double> present(const std::vector<std::optional<double>>& values);

// The mean of a measure per person over the trials with this interface in this
// task and, unless it is -1, of this target; one entry for each person, nothing
// where there is no value.
std::vector<std::optional<double>> mean_per_person(const Dataset& data, int measure, int interface,
                                                   int task, int target = -1);

}  // namespace promenade::analysis
