// The parts of load_study, for those who read a study from elsewhere than a file
// on disk: tests with a set of their own, later packed studies.
#pragma once

#include <functional>

#include "study/study.h"

namespace promenade::study {

// Gives the motion set of a name; throws InputError. load_motion_set is the usual one.
using SetLoader =
    std::function<motion::MotionSet(const std::string& name, const std::string& folder)>;

// Gives the content of a file that a study names; throws InputError or OutsideError.
using FileLoader =
    std::function<std::string(const std::string& name, const std::string& folder)>;
std::string load_file(const std::string& name, const std::string& folder);  // from the disk

// `file` names the study in problems, and its folder is where paths begin. Throws
// InputError with all problems at once.
StudyBundle read_study(const std::string& file, std::string text, const InterfaceRegistry& registry,
                       const SetLoader& load_set, const FileLoader& load_file = load_file);

// The hash over everything that a study shows: its text, its motions, the files that it
// names, the texts of its languages, the instruments and the interfaces as they are declared.
std::string study_hash(const StudyBundle& bundle, const InterfaceRegistry& registry);

}  // namespace promenade::study
