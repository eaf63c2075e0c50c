// The parts of load_study, for those who read a study from elsewhere than a file
// on disk: tests with a set of their own, packed studies, databases.
#pragma once

#include <functional>

#include "study/study.h"

namespace promenade::study {

// Gives the motion set of a name; throws InputError. load_motion_set is the usual one.
using SetLoader =
    std::function<motion::MotionSet(const std::string& name, const std::string& folder)>;

// Gives the content of a file that a study names, or of one of the program's, whose name
// begins with "builtin:"; throws InputError or OutsideError.
using FileLoader = std::function<std::string(const std::string& name, const std::string& folder)>;
std::string load_file(const std::string& name, const std::string& folder);  // from the disk

// How a part that comes with the program is named: "builtin:languages/en.toml".
std::string builtin_path(std::string_view path);
// The ratings behind the adjectives of a built-in set: "ratings/A.csv". They are written by
// simulated raters when they are asked for.
std::string simulated_ratings_path(std::string_view builtin_set);

// `file` names the study in problems, and its folder is where paths begin. Throws
// InputError with all problems at once. What only makes a new study wrong (ratings that do not
// agree) is a warning in one that was `frozen`: people have taken part in it.
StudyBundle read_study(const std::string& file, std::string text, const InterfaceRegistry& registry,
                       const SetLoader& load_set, const FileLoader& read = load_file,
                       bool frozen = false);

// A study as it was frozen, in a packed file or a database.
struct FrozenStudy {
  std::string config_text, set_bytes;
  std::vector<StudyPart> parts;  // by path
};
// `file` is where it lies. Throws InputError when it is not whole, or this program cannot read
// it any more. A file of the program's that was not frozen with it is the program's of today.
StudyBundle read_frozen_study(const std::string& file, const FrozenStudy& frozen,
                              const InterfaceRegistry& registry);

// The hash over everything that a study shows: its text, its motions, its parts (the files
// that it names, the texts of its languages, instruments, ratings of simulated raters) and the
// interfaces as they are declared.
std::string study_hash(const StudyBundle& bundle, const InterfaceRegistry& registry);

}  // namespace promenade::study
