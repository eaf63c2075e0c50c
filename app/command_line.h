// How commands declare what can be typed after them: a narrow door to CLI11, whose header takes
// longer to compile than a command does. Nothing but app/command_line.cpp, app/usage_error.cpp and
// main programs includes <CLI/CLI.hpp>. Names and meanings are those of CLI11; both classes are
// handles, so that a copy speaks of the same thing, which lives as long as the program's CLI::App.
#pragma once

#include <cstdint>
#include <functional>
#include <string>

namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace promenade::app {

// An option, a flag or a word without a name. Each rule returns the option, for the next one.
class Option {
 public:
  explicit Option(CLI::Option* option) : option_(option) {}

  Option required();
  Option description(const std::string& text);
  Option group(const std::string& heading);  // "": not in the help
  Option delimiter(char between);            // 1,2,3 as three values
  // Both ends may be typed; whole numbers for whole numbers.
  Option range(int least, int most);
  Option range(std::int64_t least, std::int64_t most);
  Option range(double least, double most);
  Option positive();  // a finite number above 0
  // Of several values: each is named again, so that the words behind it are not taken too.
  Option one_at_a_time();
  Option capture_default_str();  // the help shows what the value is now
  Option needs(const Option& other);
  Option excludes(const Option& other);
  Option excludes(const std::string& name);

  bool given() const;  // for callbacks: it was typed

 private:
  CLI::Option* option_;
};

// A command, or the program itself. What is typed goes into the `value`, which must live until the
// callback; without one typed it keeps what it has.
class Command {
 public:
  explicit Command(CLI::App* app) : app_(app) {}

  Command add_subcommand(const std::string& name, const std::string& description);
  Command require_subcommand();  // exactly one must be typed
  void allow_extras();           // words and options that nobody declared are no error

  // Text, a path, a number, a number or nothing, several of them: the types listed at the end of
  // command_line.cpp.
  template <typename T>
  Option add_option(const std::string& name, T& value, const std::string& text = "");

  Option add_flag(const std::string& name, bool& value, const std::string& text = "");
  Option add_flag(const std::string& name);  // typed or not, no matter
  Option add_flag_callback(const std::string& name, std::function<void()> callback,
                           const std::string& text);

  // What the command does, once everything that was typed is understood.
  void callback(std::function<void()> work);

 private:
  CLI::App* app_;
};

}  // namespace promenade::app
