// Who gets what in which order.
//
// A session is a row of blocks, one for each interface; the order of the interfaces
// is counterbalanced over sequences by the study's design. Within a block come the
// practice trials of all tasks, then the tasks in the order of the file, so that
// every interface meets the same tasks. The targets of a task are shuffled anew for
// each block, by (study seed, sequence, "order"); order = "fixed" keeps everything
// as in the file. A block opens with its instructions, every later trial with a
// short introduction, so that no clock starts unasked; ratings follow each trial
// that counts, and a break each block but the last where the study asks for it.
#pragma once

#include "study/study.h"

namespace promenade::study {

struct PlannedTrial {
  int position = 0;  // from 1, practice included
  int block = 0;     // from 1
  bool practice = false;
  int task = 0;       // index into Study::tasks
  int interface = 0;  // index into Study::interfaces
  int target = 0;     // index into Task::targets, or Task::practice
};

// Outside the plan: the choice of a language, before it, and the page after Decline.
enum class PageKind {
  language,
  welcome,
  consent,
  instructions,
  intro,
  trial,
  rating,
  break_,
  thanks,
  declined
};

// One screen of a session, in the order shown.
struct Page {
  PageKind kind = PageKind::welcome;
  int trial = -1;  // index into Plan::trials; for instructions the trial it prepares
};

struct Plan {
  int sequence = 0;        // the order given, from 0
  std::uint64_t seed = 0;  // of this session
  std::vector<PlannedTrial> trials;
  std::vector<Page> pages;
};

// The plan of the session that gets order number `sequence`. The same study and
// sequence give the same plan on any machine.
Plan make_plan(const Study& study, int sequence);

std::string_view to_text(PageKind kind);

const Task& task_of(const Study& study, const PlannedTrial& trial);
const Target& target_of(const Study& study, const PlannedTrial& trial);

// Orders of the conditions 0..n-1: a Williams design (2n rows for odd n), whose
// rows are balanced for position and for the condition before.
std::vector<std::vector<int>> williams_design(int n);
std::vector<std::vector<int>> latin_square(int n);

}  // namespace promenade::study
