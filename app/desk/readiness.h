// Is everything ready for a person to come? What `promenade doctor` and the reading of the study
// found, as lines with a colour.
#pragma once

#include <string>
#include <vector>

#include "app/desk/open_study.h"
#include "study/texts.h"

namespace promenade::app {

enum class Light { unknown, green, amber, red };

struct ReadyLine {
  Light light = Light::unknown;
  std::string title, says;
};

// Of the study: can it be run, what is it warned of, must it be amended?
std::vector<ReadyLine> lines_of_study(const StudyReading* reading, const study::Texts& words);

// What `promenade doctor --json` printed: titles are the names of its checks. Empty when that is
// none.
std::vector<ReadyLine> read_doctor(const std::string& json);

// "line 15: ...": the file is known.
std::string problem_words(const Problem& problem, const study::Texts& words);

// The worst of them; a session should begin when it is green or amber.
Light worst(const std::vector<ReadyLine>& lines);

}  // namespace promenade::app
