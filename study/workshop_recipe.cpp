#include "study/workshop_recipe.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "motion/angles.h"
#include "motion/files.h"
#include "motion/set_file.h"
#include "study/recipe.h"
#include "study/toml_text.h"

namespace promenade::study {
namespace {

namespace fs = std::filesystem;

// The shortest text that reads back as the same number, whatever the locale.
std::string number(double value) { return fmt::format("{}", value); }

std::string key(const char* name, const std::string& value) {
  return fmt::format("{} = {}\n", name, value);
}

// From the recipe's folder, unless that leads far up: whoever moves both together keeps them
// together.
std::string folder_from(const std::string& file, const std::string& folder) {
  std::error_code error;
  const fs::path from = fs::absolute(file, error).lexically_normal().parent_path();
  const std::string way = fs::path(folder).lexically_relative(from).generic_string();
  return way.empty() || way.starts_with("../../../") ? folder : way;
}

std::string figure_text(const motion::FigureOptions& figure) {
  std::string text;
  if (figure.unit_m) text += key("unit_m", number(*figure.unit_m));
  if (figure.z_up) text += key("up", *figure.z_up ? "\"z\"" : "\"y\"");
  return text;
}

std::string list(const std::vector<double>& numbers, std::size_t from, std::size_t to) {
  std::string text = "[";
  for (std::size_t i = from; i < to; ++i) text += (i > from ? ", " : "") + number(numbers[i]);
  return text + "]";
}

std::string options_text(const Workshop& workshop) {
  const motion::SetOptions& options = workshop.options();
  const motion::SetOptions standard;
  std::string text;
  if (options.cycles_per_take != 1) {
    text += key("cycles_per_take", std::to_string(options.cycles_per_take));
  }
  if (options.search.most_loop_error_m != 0.15) {
    text += key("most_loop_error_m", number(options.search.most_loop_error_m));
  }
  if (options.search.most_turn != standard.search.most_turn) {
    text += key("most_turn_deg", number(options.search.most_turn * 180 / motion::pi));
  }
  for (std::size_t t = 0; t < workshop.takes().size(); ++t) {
    if (workshop.takes()[t].source.file != options.skeleton) continue;
    text += key("skeleton", toml_quoted(workshop.label(t)));
  }
  if (!options.walk) {
    text += key("motion", "\"other\"");
    text += key("key_phases", list(options.key_phases, 0, options.key_phases.size()));
  }
  return text + figure_text(options.figure);
}

std::string cycle_text(const motion::GivenCycle& cycle) {
  std::string text = "[[take.cycle]]\n";
  if (!cycle.name.empty()) text += key("name", toml_quoted(cycle.name));
  text += key("first", number(cycle.frames.front()));
  if (cycle.frames.size() > 2) {
    text += key("keytimes", list(cycle.frames, 1, cycle.frames.size() - 1));
  }
  return text + key("last", number(cycle.frames.back()));
}

std::string load_text(const motion::LoadOptions& load, const std::string& folder) {
  std::string text;
  if (!load.skeleton.empty()) {
    const std::string way =
        fs::absolute(load.skeleton).lexically_normal().lexically_relative(folder).generic_string();
    text += key("asf", toml_quoted(way.empty() ? load.skeleton.string() : way));
  }
  if (load.rate) text += key("frames_per_second", number(*load.rate));
  return text;
}

std::string take_text(const Workshop& workshop, std::size_t t) {
  const motion::TakeSource& source = workshop.takes()[t].source;
  const Verdict& verdict = workshop.verdict(t);
  std::string text = "\n[[take]]\n" + key("file", toml_quoted(workshop.label(t)));
  text += key("style", toml_quoted(source.style));
  const bool unreadable =
      verdict.state == TakeState::unreadable || verdict.state == TakeState::unread;
  if (unreadable || verdict.state == TakeState::left_out) text += key("use", "false");
  if (source.from) text += key("from", std::to_string(*source.from));
  if (source.to) text += key("to", std::to_string(*source.to));
  text += figure_text(source.figure) + load_text(source.load, workshop.folder());
  for (const motion::GivenCycle& cycle : source.cycles) text += cycle_text(cycle);
  return text;
}

std::string credit_of(const motion::SetOptions& options) {
  return options.credit.empty() ? "not said" : options.credit;
}

}  // namespace

std::string recipe_text(const Workshop& workshop, const std::string& file) {
  std::string text = "# Made at the desk. `promenade set build` makes the same set of it.\n" +
                     key("name", toml_quoted(workshop.options().name)) +
                     key("credit", toml_quoted(credit_of(workshop.options()))) +
                     key("folder", toml_quoted(folder_from(file, workshop.folder()))) +
                     options_text(workshop);
  for (std::size_t t = 0; t < workshop.takes().size(); ++t) text += take_text(workshop, t);
  return text;
}

std::string recipe_beside(const std::string& set_file) {
  return fs::path(set_file).replace_extension(".recipe.toml").string();
}

motion::BuiltSet make_set(const std::string& recipe_file, const std::string& set_file,
                          const std::function<void(int step, int steps)>& progress) {
  Recipe recipe = load_recipe(recipe_file);
  const int steps = 2 * static_cast<int>(recipe.takes.size());
  int step = 0;
  const auto next = [&] {
    if (progress) progress(step++, steps);
  };
  hash_takes(recipe, next);
  motion::BuiltSet built =
      motion::build_set(recipe.takes, recipe.options, [&](const motion::TakeSource&) { next(); });
  write_file(set_file, motion::to_bytes(built.set));
  return built;
}

}  // namespace promenade::study
