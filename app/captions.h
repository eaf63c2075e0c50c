// What people read: the program's texts and the names of the motions, in one language.
#pragma once

#include <string>
#include <vector>

#include "study/study.h"

namespace promenade::app {

struct Captions {
  study::Texts texts;
  std::vector<std::string> names;  // N, of the cycles: "happy 2" for "happy_2"
  std::vector<int> by_name;        // the cycles in the order of their names
  std::string language = "en";     // of `texts`
};

Captions captions_of(study::Texts texts, const motion::MotionSet& set);
// Of a study, in the texts that were frozen with it. Throws InputError for a language that
// neither it nor the program speaks.
Captions captions_in(const std::string& language, const study::StudyBundle& bundle);

// All of it: what the fonts must be able to write.
std::vector<std::string> words_of(const Captions& captions);

}  // namespace promenade::app
