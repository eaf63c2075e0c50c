#include "app/usage_error.h"

#include <vector>

#include "motion/did_you_mean.h"

namespace promenade::app {
namespace {

// The command that was begun, and its own command, as `set build`.
const CLI::App& innermost(const CLI::App& program) {
  const std::vector<CLI::App*> begun = program.get_subcommands();
  return begun.empty() ? program : innermost(*begun.front());
}

std::string full_name(const CLI::App& command) {
  const CLI::App* parent = command.get_parent();
  return (parent ? full_name(*parent) + " " : "") + command.get_name();
}

std::vector<std::string> options_of(const CLI::App& command) {
  std::vector<std::string> names;
  for (const CLI::Option* option : command.get_options()) {
    for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
  }
  return names;
}

std::vector<std::string> commands_of(const CLI::App& command) {
  std::vector<std::string> names;
  for (const CLI::App* one : command.get_subcommands(nullptr)) names.push_back(one->get_name());
  return names;
}

std::string wrong_option(const CLI::App& command, const std::string& word) {
  const std::string name = word.substr(0, word.find('='));
  return "there is no option " + name + did_you_mean(name, options_of(command));
}

// `extras` is in no certain order: of several words the one that is like a command was meant as
// one.
std::string wrong_command(const CLI::App& command, const std::vector<std::string>& extras) {
  const std::vector<std::string> commands = commands_of(command);
  std::string wrong = extras.back();
  for (const std::string& word : extras) {
    if (!did_you_mean(word, commands).empty()) wrong = word;
  }
  return "there is no command \"" + wrong + "\"" + did_you_mean(wrong, commands);
}

std::string problem_of(const CLI::App& program, const CLI::App& command, const CLI::Error& error) {
  const std::vector<std::string> extras = program.remaining(true);
  const bool wants_command = !commands_of(command).empty();
  const bool unexpected = error.get_exit_code() == static_cast<int>(CLI::ExitCodes::ExtrasError);
  if (extras.empty() || (!unexpected && !wants_command)) return error.what();
  for (const std::string& word : extras) {
    if (word.rfind('-', 0) == 0) return wrong_option(command, word);
  }
  if (wants_command) return wrong_command(command, extras);
  return "\"" + extras.back() + "\" is one word too many";
}

}  // namespace

std::string usage_error(const CLI::App* program, const CLI::Error& error) {
  const CLI::App& command = innermost(*program);
  const std::string name = full_name(command);
  return name + ": error: " + problem_of(*program, command, error) + "\n`" + name +
         " --help` lists what can be said\n";
}

}  // namespace promenade::app
