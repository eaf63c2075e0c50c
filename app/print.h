// How commands speak: one JSON document on stdout, words for people on stderr
// (docs/commands.md).
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "motion/problem.h"

namespace promenade::app {

using Json = nlohmann::ordered_json;

// Names that are not UTF-8 must not end the program: their bytes are replaced.
void print_json(const Json& document);
void print_text(const std::string& text);                   // to stdout
void print_note(const std::string& sentence);               // to stderr
void print_problems(const std::vector<Problem>& problems);  // to stderr

Json to_json(const Problem& problem);
Json to_json(const std::optional<double>& value);  // null: nothing

// "  done 12 of 40" on stderr, over itself, when that is a terminal; for a program that started this
// one and set PROMENADE_PROGRESS, a line of its own.
void show_progress(const std::string& what, int done, int count);

// True once Ctrl-C was pressed, the program told to end (SIGTERM) or its terminal
// closed (SIGHUP); watching begins with the first call.
bool interrupted();

}  // namespace promenade::app
