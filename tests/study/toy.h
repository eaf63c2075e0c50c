// A tiny motion set and two toy interfaces, so that the tests of study/ need no
// window, no captures and no built-in set.
#pragma once

#include <string>

#include "study/load_study.h"

namespace promenade::study::toy {

// Three walks on four joints at 12 phases: "near", "side" and "far", each a pose of
// its own; "far" is the slowest. All 20 joints of the body hang on the four.
motion::MotionSet motion_set();

// "pick": one walk at a time, as a list of labels does. kind "pick", target: the walk.
// "mix": a slider for each walk, 0 to 1, normalised. kind "slide", target: the walk;
// the parameter "rule" is "share" or "square", "steps" a number, "quick" a boolean.
const InterfaceRegistry& registry();

// Both interfaces; match "far" (auto threshold, 45 s) and find one quality; one
// rating; practice of "side".
std::string study_text();

// A study in the text, over the toy set. Throws InputError.
StudyBundle bundle(const std::string& text = study_text());

}  // namespace promenade::study::toy
