// What is said about a command line that cannot be read.
#pragma once

#include <CLI/CLI.hpp>
#include <string>

namespace promenade::app {

// "promenade report: error: there is no option --exlude; did you mean \"--exclude\"?", and where to
// read on. For CLI::App::failure_message of the program.
std::string usage_error(const CLI::App* program, const CLI::Error& error);

}  // namespace promenade::app
