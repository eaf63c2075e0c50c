// The names in a study file, in its order, without judging the rest: for those who
// have only the text that a database keeps.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace promenade::study {

// Targets of a task that are made by lot.
struct OutlinedDraw {
  std::string task, model;  // "adjectives" and so on
};

struct Outline {
  std::vector<std::string> interfaces;    // [[interface]]: name, else type
  std::vector<std::string> tasks;         // [[task]]: name
  std::vector<std::string> targets;       // and qualities, of all tasks, each once
  std::vector<std::string> ratings;       // [[rating]]: item
  std::vector<std::string> guesses;       // tasks of the kind guess
  std::string order;                      // of the interfaces, as [study] says; empty: no [study]
  std::vector<std::string> types = {};    // [[interface]]: type, else name; beside `interfaces`
  std::string published = {};             // [study] published; empty: none
  std::vector<OutlinedDraw> draws = {};   // of match and guess tasks, each model once
  std::vector<std::string> stimuli = {};  // [[stimulus]]: name
};

// What cannot be read is left out; a text that is no TOML has an empty outline.
Outline outline_of(std::string_view config_text);

}  // namespace promenade::study
