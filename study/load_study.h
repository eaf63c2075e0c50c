// The parts of load_study, for those who read a study from elsewhere than a file
// on disk: tests with a set of their own, later packed studies.
#pragma once

#include <functional>

#include "study/study.h"

namespace promenade::study {

// Gives the motion set of a name; throws InputError. load_motion_set is the usual one.
using SetLoader =
    std::function<motion::MotionSet(const std::string& name, const std::string& folder)>;

// `file` names the study in problems, and its folder is where paths begin. Throws
// InputError with all problems at once.
StudyBundle read_study(const std::string& file, std::string text, const InterfaceRegistry& registry,
                       const SetLoader& load_set);

// The hash over everything that a study shows: its text, its motions, the texts of
// its languages and the interfaces as they are declared.
std::string study_hash(const StudyBundle& bundle, const InterfaceRegistry& registry);

}  // namespace promenade::study
