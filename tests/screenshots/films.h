// Which pictures there are: a film is one session in one study, photographed as it
// goes.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "tests/screenshots/studies.h"
#include "tests/screenshots/studio.h"

namespace promenade::app::screenshots {

struct Reel {
  Album& album;
  std::string prefix;  // of the names of its pictures: "en-1280x720-10"
  std::string part;    // only pictures with this in their name; empty: all

  bool wants(const std::string& what) const {
    return (prefix + "-" + what).find(part) != std::string::npos;
  }
};

struct Film {
  study::StudyBundle bundle;
  std::string name = "";  // of its one picture; empty: every page of the session
  // Plays until that picture can be taken; else not used.
  std::function<void(Studio&)> play = {};
  bool pilot = false;
  bool asks_language = false;
  bool simulated = true;         // else its code can be refused
  bool interrupted = false;      // sessions were, and may go on
  bool left = false;             // somebody left, to go on another day
  bool interfaces_only = false;  // not the pages that are the same with any set

  int styles() const { return bundle.space.set.size(); }
};

std::vector<Film> all_films();
// Goes on to a trial that counts, and into the middle of it.
void to_trial(Studio& studio);
void shoot_film(const Film& film, Room& room, const std::string& language, const Reel& reel);

}  // namespace promenade::app::screenshots
