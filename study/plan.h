// Who gets what in which order.
//
// A session is three nested loops over interfaces, tasks and targets; Study::nesting says
// which is the outermost, and a block is one turn of it. The order of the interfaces is
// counterbalanced over sequences by the study's design; tasks and targets are in the order of
// the file or shuffled, by (study seed, sequence, "order"). With the interface outermost the
// practice trials of all tasks stand at the head of each block; else all practice comes
// first, a block for each interface. Rate tasks have no interface: each is a block of its
// own, before all others where it stands first in the file, else behind them.
//
// The first trial of a block, and of an interface, is opened by instructions, every other by a
// short introduction, so that no clock starts unasked. Questionnaires and breaks stand where
// the study asks for them.
#pragma once

#include "study/study.h"

namespace promenade::study {

struct PlannedTrial {
  int position = 0;  // from 1, practice included
  int block = 0;     // from 1
  bool practice = false;
  int task = 0;       // index into Study::tasks
  int interface = 0;  // index into Study::interfaces; -1 in rate tasks
  int target = 0;     // index into Task::targets, or Task::practice
  int showing = 1;    // of this target in this task: 2 where a motion comes again
  // N: of a target that is drawn for each participant; empty: Target::weights says it.
  Eigen::VectorXd drawn = {};
};

// Outside the plan: the choice of a language, before it, and the page after Decline.
enum class PageKind {
  language,
  welcome,
  consent,
  instructions,
  intro,
  trial,
  questionnaire,
  release,  // practice is over when the experimenter says so
  break_,
  thanks,
  declined
};

// One screen of a session, in the order shown.
struct Page {
  PageKind kind = PageKind::welcome;
  // Index into Plan::trials; of instructions the trial that they prepare, of other pages the
  // one that they follow. -1: none.
  int trial = -1;
  int questionnaire = -1;  // index into Study::questionnaires
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

// How many orders of interfaces the design has before they repeat: 1 where they are fixed or
// drawn by lot.
int rows_of_design(const Study& study);
// How many sequences bring every order of the design together with every rotation of the lists
// of targets.
int round_of_orders(const Study& study);
// The same, and every motion of a split design was rated equally often: the number of
// participants is balanced when it is a multiple of this.
int round_of_design(const Study& study);
// After so many sequences everything that is balanced by number begins again, and so a person
// can be replaced by one whose number is the same modulo this.
int cells_of_design(const Study& study);

// Which of the lists of a task this interface gets.
int list_of(const Study& study, int task, int interface, int sequence);

// N weights of a target of this task that is drawn for each participant (Target::draw).
Eigen::VectorXd drawn_target(const Study& study, int task, const Target& target, int sequence);

const Task& task_of(const Study& study, const PlannedTrial& trial);
const Target& target_of(const Study& study, const PlannedTrial& trial);
// N weights of the motion that the trial is about; null in find tasks.
const Eigen::VectorXd* target_weights(const Study& study, const PlannedTrial& trial);

// Orders of the conditions 0..n-1: a Williams design (2n rows for odd n), whose
// rows are balanced for position and for the condition before.
std::vector<std::vector<int>> williams_design(int n);
std::vector<std::vector<int>> latin_square(int n);

}  // namespace promenade::study
