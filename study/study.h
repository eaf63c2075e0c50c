// What a study is, as its file says it (docs/study-file.md describes the
// file), and with everything it names at hand.
#pragma once

#include <array>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "motion/distance.h"
#include "motion/motion_space.h"
#include "motion/place.h"
#include "motion/pose_blender.h"
#include "motion/problem.h"
#include "study/instrument.h"
#include "study/interface.h"
#include "study/process_measures.h"
#include "study/split.h"
#include "study/texts.h"

namespace promenade::study {

// [[interface]]: one condition of the study.
struct InterfaceUse {
  std::string name;                             // as in the results; the type's name unless given
  std::string type;                             // in the registry
  Parameters parameters;                        // complete
  std::shared_ptr<const InterfaceModel> model;  // what its type prepared; null: nothing
};

struct Stimulus;  // study/stimulus.h

// What a trial asks for: a motion to reproduce or to rate, or a quality to find.
struct Target {
  std::string name;  // as in the results
  // N; nothing in find tasks, where `draw` is set, and of a stimulus.
  std::optional<Eigen::VectorXd> weights;
  LocalText quality;      // the asked word in each language (find)
  std::string pair = {};  // of adjectives, the asked word second: scores it (find); empty: by name
  Place place = {};       // in the study's file
  // Drawn anew for each participant: N weights. Empty: the same for all.
  std::function<Eigen::VectorXd(Rng&)> draw = {};
  std::string stream = {};   // of the draw: targets of one stream are drawn together
  double least_start_m = 0;  // of the draw: D at the start is never less, metres
  std::shared_ptr<const Stimulus> stimulus = {};  // rate: a motion that is no blend; null: none
};

enum class TaskKind {
  match,  // reproduce a motion
  find,   // find a quality
  guess,  // reproduce a motion without seeing what is made; only Done ends it
  rate    // answer an instrument about a motion, beside a reference; no interface
};

// Does the task have a motion that the made one is compared with?
constexpr bool has_target_motion(TaskKind kind) {
  return kind == TaskKind::match || kind == TaskKind::guess;
}

// How the targets of a task are dealt to the interfaces.
enum class Deal {
  same,    // all interfaces get all of them
  rotated  // lists of equal difficulty, rotated over the interfaces from person to person
};

// [[task]]
struct Task {
  std::string name;
  TaskKind kind = TaskKind::match;
  std::optional<double> limit_s;      // nothing: as long as it takes
  std::optional<double> threshold_m;  // D that wins (match, guess); nothing: only Done ends it
  int reference = -1;                 // the cycle that walks beside as a yardstick; -1: none
  bool blind = false;                 // the created figure is not shown; only Done ends the trial
  bool playback = false;              // the walk can be paused, slowed down and scrubbed
  bool has_done = true;               // false: only the threshold or the limit ends a trial
  std::int64_t dwell_us = 500'000;    // how long D must stay below it without a change
  motion::DistanceTimes distance = motion::DistanceTimes::time;  // when D compares
  // The task of kind guess, an index into Study::tasks, from whose end state a trial with the
  // same interface and target begins; it is over at once when that is below the threshold.
  // -1: trials begin from the average.
  int start_guess = -1;
  int instrument = -1;          // of a rate task: index into Study::instruments
  std::vector<int> interfaces;  // indices into Study::interfaces; none in rate tasks
  std::vector<Target> targets;
  std::vector<Target> practice;  // targets of practice trials, per interface
  Deal deal = Deal::same;
  // With Deal::rotated: for each list the indices of its targets, as many lists as interfaces.
  std::vector<std::vector<int>> lists;
  // Of a rate task: which of its targets each person rates, and which twice; nothing: all of
  // them once.
  std::optional<SplitDesign> split;
  int repeats = 0;  // of a rate task: so many of a person's motions come a second time
};

// [[questionnaire]]: an instrument, and where in the session it is asked.
struct Questionnaire {
  enum class When {
    start,  // after consent
    trial,  // after each trial that counts
    task,   // after the last trial of a task with an interface
    block,  // after each block
    end     // before the last page
  };
  int instrument = 0;  // index into Study::instruments
  When when = When::end;
  std::vector<int> tasks;  // trial, task: indices into Study::tasks; empty: all
};

// [practice]: what has to happen before the trials that count.
struct Practice {
  enum class Until {
    done,       // every practice trial was done once
    criterion,  // enough of them were successes, or `most_rounds` have passed
    released    // the experimenter says so
  };
  Until until = Until::done;
  int successes = 1;    // criterion: in one round of a block
  int most_rounds = 3;  // criterion: then it goes on all the same
};

// What becomes of a session that was interrupted: by a crash, a power cut, a kill.
enum class ResumePolicy {
  continue_,   // from the very state
  redo_trial,  // the trial that ran is begun anew
  redo_block   // the block is begun anew
};

// What `withdraw` removes, as the consent text says.
enum class Withdrawal {
  everything,  // all rows of the person
  link         // what tells whose they are; answers and trials stay
};

// [safety]
struct Safety {
  ResumePolicy resume = ResumePolicy::continue_;
  Withdrawal withdrawal = Withdrawal::everything;
  std::string copy_to;  // a folder that gets a verified copy after each session; empty: none
  bool leave = false;   // people may go on another day
  std::string keep;     // how long data are kept, for the page for an ethics board; empty: not said
};

// Where all examples walk beside the task, as the video of [O] 6 did.
enum class ExamplesWall { none, panel, screen };

// [display]
struct Display {
  bool paper_colours = false;
  bool travels = true;  // the figures walk over the ground; else on the spot
  int screen = 0;       // which display, from 1; 0: the first one
  double scale = 1;     // of the picture, 0.5 to 1 of the screen
  ExamplesWall examples = ExamplesWall::none;
};

// [breaks]: a page of rest.
struct Breaks {
  bool after_block = false;   // between two blocks
  int after_trials = 0;       // after so many trials that count in a block; 0: never
  std::int64_t least_us = 0;  // nobody goes on before
};

// Of the interfaces, over the participants.
enum class Order { williams, latin, random, fixed };
// Of tasks, or of the targets of a task, within a session.
enum class Sequence { fixed, random };
// The three factors of a study; how their loops are nested is up to it.
enum class Factor { interface, task, target };

struct Study {
  std::string name, version = "1";
  std::string set = "builtin:A";
  std::string published;     // the printed study that it repeats (study/published.h); empty: none
  std::string ratings_file;  // of the motions on pairs of adjectives; empty: none is named
  std::vector<std::string> languages = {"en"};
  std::uint64_t seed = 1;
  Order order = Order::williams;
  Sequence task_order = Sequence::fixed, target_order = Sequence::random;
  // The outermost loop first; a block is one turn of it.
  std::array<Factor, 3> nesting = {Factor::interface, Factor::task, Factor::target};
  int participants = 0;      // how many are planned; 0: not said
  double most_minutes = 60;  // a longer session is warned of
  Display display;
  Breaks breaks;
  Practice practice;
  Safety safety;
  std::vector<InterfaceUse> interfaces;
  std::vector<Task> tasks;
  std::vector<Instrument> instruments;
  std::vector<Questionnaire> questionnaires;
  std::vector<std::shared_ptr<const Stimulus>> stimuli;  // [[stimulus]], in the order of the file
  LocalText title, consent;                              // own texts of the study
};

// By its name; null: there is none.
inline const Task* find_task(const Study& study, std::string_view name) {
  for (const Task& task : study.tasks) {
    if (task.name == name) return &task;
  }
  return nullptr;
}

// A file that a study is made of: one that it names (ratings, an instrument, targets), or one
// of the program's that it uses.
struct StudyPart {
  std::string path;  // as the study says it; "builtin:languages/en.toml" is the program's
  std::string content;
};

class Impressions;

// A study, ready to run.
struct StudyBundle {
  Study study;
  std::string file;         // as the user named it
  std::string config_text;  // letter by letter
  std::string sha256;       // over everything that the study shows
  motion::MotionSpace space;
  motion::PoseBank bank;  // of this space: what is shown comes from it
  CoverageMap coverage;
  // Behind the adjectives; null: no interface asked for it, or there are no ratings.
  std::shared_ptr<const AdjectiveModel> adjectives;
  // How the walks seem to simulated people (study/impressions.h).
  std::shared_ptr<const Impressions> impressions;
  std::string set_bytes, set_sha256;
  std::vector<StudyPart> parts;  // by path
  StudyTexts texts;              // of its languages; those that were frozen with it, if it was
  std::vector<Problem> warnings;
};

// The motion set that a study or a command names: "builtin:A", or a file, relative
// to `folder`. Throws InputError.
motion::MotionSet load_motion_set(const std::string& name, const std::string& folder);

// Reads a study and everything that it names. Throws InputError with all problems
// at once. `file` may also be "configs/demo.toml", which is embedded, or a packed study
// (study/pack.h), which is known by its first bytes.
StudyBundle load_study(const std::string& file, const InterfaceRegistry& registry);

// What participants of this study read in a language; throws InputError for one that neither
// the study nor the program knows.
inline Texts texts_of(const StudyBundle& bundle, std::string_view language) {
  return texts_in(bundle.texts, language);
}

// The weights that every interface starts from: the average of the set.
Eigen::VectorXd start_weights(const motion::MotionSpace& space);

}  // namespace promenade::study
