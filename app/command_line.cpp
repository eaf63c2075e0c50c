#include "app/command_line.h"

#include <CLI/CLI.hpp>
#include <cmath>
#include <filesystem>
#include <optional>
#include <vector>

namespace promenade::app {
namespace {

// "nan" is a number to those who read it, and neither below nor above anything.
std::string trouble_with_number(const std::string& typed) {
  double value = 0;
  if (CLI::detail::lexical_cast(typed, value) && std::isfinite(value)) return {};
  return "Value " + typed + " is no finite number";
}

std::string trouble_with_positive(const std::string& typed) {
  double value = 0;
  if (CLI::detail::lexical_cast(typed, value) && std::isfinite(value) && value > 0) return {};
  return "Value " + typed + " is no number above 0";
}

}  // namespace

Option Option::required() { return Option(option_->required()); }

Option Option::description(const std::string& text) { return Option(option_->description(text)); }

Option Option::group(const std::string& heading) { return Option(option_->group(heading)); }

Option Option::delimiter(char between) { return Option(option_->delimiter(between)); }

Option Option::range(int least, int most) {
  return Option(option_->check(CLI::Range(least, most)));
}

Option Option::range(std::int64_t least, std::int64_t most) {
  return Option(option_->check(CLI::Range(least, most)));
}

Option Option::range(double least, double most) {
  return Option(
      option_->check(CLI::Validator(trouble_with_number, ""))->check(CLI::Range(least, most)));
}

Option Option::positive() {
  return Option(option_->check(CLI::Validator(trouble_with_positive, "POSITIVE")));
}

Option Option::one_at_a_time() { return Option(option_->allow_extra_args(false)); }

Option Option::capture_default_str() { return Option(option_->capture_default_str()); }

Option Option::needs(const Option& other) { return Option(option_->needs(other.option_)); }

Option Option::excludes(const Option& other) { return Option(option_->excludes(other.option_)); }

Option Option::excludes(const std::string& name) { return Option(option_->excludes(name)); }

bool Option::given() const { return option_->count() > 0; }

Command Command::add_subcommand(const std::string& name, const std::string& description) {
  return Command(app_->add_subcommand(name, description));
}

Command Command::require_subcommand() { return Command(app_->require_subcommand(1)); }

void Command::allow_extras() { app_->allow_extras(); }

template <typename T>
Option Command::add_option(const std::string& name, T& value, const std::string& text) {
  return Option(app_->add_option(name, value, text));
}

Option Command::add_flag(const std::string& name, bool& value, const std::string& text) {
  return Option(app_->add_flag(name, value, text));
}

Option Command::add_flag(const std::string& name) { return Option(app_->add_flag(name)); }

Option Command::add_flag_callback(const std::string& name, std::function<void()> callback,
                                  const std::string& text) {
  return Option(app_->add_flag_callback(name, std::move(callback), text));
}

void Command::callback(std::function<void()> work) { app_->callback(std::move(work)); }

using Text = const std::string&;
template Option Command::add_option(Text, std::string&, Text);
template Option Command::add_option(Text, std::filesystem::path&, Text);
template Option Command::add_option(Text, int&, Text);
template Option Command::add_option(Text, double&, Text);
template Option Command::add_option(Text, std::int64_t&, Text);
template Option Command::add_option(Text, std::uint64_t&, Text);
template Option Command::add_option(Text, std::optional<int>&, Text);
template Option Command::add_option(Text, std::optional<double>&, Text);
template Option Command::add_option(Text, std::optional<std::uint64_t>&, Text);
template Option Command::add_option(Text, std::vector<int>&, Text);
template Option Command::add_option(Text, std::vector<std::string>&, Text);

}  // namespace promenade::app
