// What a study is, as its file says it (docs/study-file.md describes the
// file), and with everything it names at hand.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "motion/distance.h"
#include "motion/motion_space.h"
#include "motion/place.h"
#include "motion/pose_blender.h"
#include "motion/problem.h"
#include "study/interface.h"
#include "study/texts.h"

namespace promenade::study {

// [[interface]]: one condition of the study.
struct InterfaceUse {
  std::string name;                             // as in the results; the type's name unless given
  std::string type;                             // in the registry
  Parameters parameters;                        // complete
  std::shared_ptr<const InterfaceModel> model;  // what its type prepared; null: nothing
};

// What a trial asks for: a motion to reproduce, or a quality to find.
struct Target {
  std::string name;                        // as in the results
  std::optional<Eigen::VectorXd> weights;  // N; nothing in tasks without a target motion
  LocalText quality;                       // the asked word in each language (find)
  Place place = {};                        // in the study's file
};

enum class TaskKind { match, find };

// [[task]]
struct Task {
  std::string name;
  TaskKind kind = TaskKind::match;
  std::optional<double> limit_s;      // nothing: as long as it takes
  std::optional<double> threshold_m;  // D that wins (match); nothing: only Done ends it
  int reference = -1;                 // the cycle that walks beside as a yardstick; -1: none
  bool blind = false;                 // the created figure is not shown; only Done ends the trial
  bool playback = false;              // the walk can be paused, slowed down and scrubbed
  std::int64_t dwell_us = 500'000;    // how long D must stay below it without a change
  motion::DistanceTimes distance = motion::DistanceTimes::time;  // when D compares (match)
  std::vector<int> interfaces;                                   // indices into Study::interfaces
  std::vector<Target> targets;
  std::vector<Target> practice;  // targets of practice trials, per interface
};

// [[rating]]: a question after each trial on a scale of `points`.
struct Rating {
  std::string item;
  LocalText question, low, high;
  int points = 7;
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

// [breaks]: a page of rest between two blocks.
struct Breaks {
  bool after_block = false;
  std::int64_t least_us = 0;  // nobody goes on before
};

enum class Order { williams, latin, random, fixed };

struct Study {
  std::string name, version = "1";
  std::string set = "builtin:A";
  std::string ratings_file;  // of the motions on pairs of adjectives; empty: none is named
  std::vector<std::string> languages = {"en"};
  std::uint64_t seed = 1;
  Order order = Order::williams;
  Display display;
  Breaks breaks;
  std::vector<InterfaceUse> interfaces;
  std::vector<Task> tasks;
  std::vector<Rating> ratings;
  LocalText title, consent;  // own texts of the study
};

// A study, ready to run.
struct StudyBundle {
  Study study;
  std::string file;         // as the user named it
  std::string config_text;  // letter by letter
  std::string sha256;       // over everything that the study shows
  motion::MotionSpace space;
  motion::PoseBank bank;  // of this space: what is shown comes from it
  // Behind the adjectives; null: no interface asked for it, or there are no ratings.
  std::shared_ptr<const AdjectiveModel> adjectives;
  std::string ratings_sha256;  // of the file of ratings; empty: none is named
  std::string set_bytes, set_sha256;
  std::vector<Problem> warnings;
};

// The motion set that a study or a command names: "builtin:A", or a file, relative
// to `folder`. Throws InputError.
motion::MotionSet load_motion_set(const std::string& name, const std::string& folder);

// Reads a study and everything that it names. Throws InputError with all problems
// at once. `file` may also be "configs/demo.toml", which is embedded.
StudyBundle load_study(const std::string& file, const InterfaceRegistry& registry);

// The weights that every interface starts from: the average of the set.
Eigen::VectorXd start_weights(const motion::MotionSpace& space);

}  // namespace promenade::study
