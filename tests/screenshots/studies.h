// Made-up studies that show everything once.
#pragma once

#include <string>
#include <vector>

#include "study/load_study.h"

namespace promenade::app::screenshots {

// What a picture's study has of its own; the rest is the same for all.
struct Scene {
  std::string set = "builtin:A";
  std::string display = "";                  // lines of [display]
  std::string breaks = "";                   // lines of [breaks]
  std::string match = "";                    // further lines of the task "match"
  std::vector<std::string> interfaces = {};  // empty: all that the set can have
  bool long_names = false;                   // of the styles
};

// Can this interface be used with the set of the scene? If not, a line on stderr says why.
bool can_have(const Scene& scene, const std::string& interface);

// A study with a page for each instrument, tasks to rate and to guess, and practice that the
// experimenter ends.
study::StudyBundle make_study_of_pages();

// An interface that the set cannot have is left out; a line on stderr says so.
study::StudyBundle make_study(const Scene& scene);

}  // namespace promenade::app::screenshots
