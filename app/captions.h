// What people read: the program's texts and the names of the motions, in one language.
#pragma once

#include <string>
#include <vector>

#include "motion/motion_set.h"
#include "study/texts.h"

namespace promenade::app {

struct Captions {
  study::Texts texts;
  std::vector<std::string> names;  // N, of the cycles: "happy 2" for "happy_2"
  std::vector<int> by_name;        // the cycles in the order of their names
};

// Throws InputError for a language that the program does not speak.
Captions captions_in(const std::string& language, const motion::MotionSet& set);

// All of it: what the fonts must be able to write.
std::vector<std::string> words_of(const Captions& captions);

}  // namespace promenade::app
