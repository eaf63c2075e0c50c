#include "study/recipe.h"

#include <algorithm>
#include <filesystem>

#include "motion/angles.h"
#include "motion/files.h"
#include "study/identity.h"
#include "study/recipe_cuts.h"
#include "study/toml_reader.h"

namespace promenade::study {
namespace {

namespace fs = std::filesystem;
using motion::GivenCycle;
using motion::TakeSource;

constexpr double most_frame = 1e9;
constexpr std::size_t walk_keys = 5;

motion::FigureOptions read_figure(const TomlTable& table) {
  motion::FigureOptions figure;
  figure.unit_m = table.number("unit_m", 1e-6, 1e3);
  if (const auto up = table.choice("up", {"y", "z"})) figure.z_up = *up == "z";
  return figure;
}

// For captures in two files (.asf and .amc), and without a frame rate of their own.
motion::LoadOptions read_load(const TomlTable& table, const fs::path& folder) {
  motion::LoadOptions load;
  load.rate = table.number("frames_per_second", 1, 1000);
  const auto asf = table.text("asf");
  if (!asf) return load;
  load.skeleton = (folder / *asf).lexically_normal();
  std::error_code error;
  if (!fs::is_regular_file(load.skeleton, error)) {
    table.error("asf", "there is no file " + load.skeleton.string());
  }
  return load;
}

// first, keytimes, last of one [[take.cycle]].
GivenCycle read_cycle(const TomlTable& table) {
  GivenCycle cycle;
  cycle.place = table.place();
  cycle.name = table.text("name").value_or("");
  table.require("first");
  table.require("last");
  const auto first = table.number("first", 0, most_frame);
  const auto last = table.number("last", 0, most_frame);
  cycle.frames = table.numbers("keytimes");
  if (!first || !last) return cycle;
  cycle.frames.insert(cycle.frames.begin(), *first);
  cycle.frames.push_back(*last);
  for (std::size_t k = 1; k < cycle.frames.size(); ++k) {
    if (cycle.frames[k] > cycle.frames[k - 1]) continue;
    table.error(cycle.frames.size() > 2 ? "keytimes" : "last",
                "first, keytimes and last must ascend: they are frames of the file");
    break;
  }
  return cycle;
}

void read_frames(const TomlTable& table, TakeSource& take) {
  const auto frame = [&](std::string_view key) -> std::optional<int> {
    const auto value = table.integer(key, 0, static_cast<std::int64_t>(most_frame));
    if (!value) return std::nullopt;
    return static_cast<int>(*value);
  };
  if (const auto from = frame("from")) take.from = from;
  if (const auto to = frame("to")) take.to = to;
  if (take.from && take.to && *take.from >= *take.to) {
    table.error("to", "the last frame must come after the first");
  }
}

// What a [[take]] says of itself, whatever there is on disk.
TakeSource read_own(const TomlTable& table) {
  TakeSource own;
  own.figure = read_figure(table);
  own.load.rate = table.number("frames_per_second", 1, 1000);
  read_frames(table, own);
  for (const TomlTable& cycle : table.tables("cycle")) own.cycles.push_back(read_cycle(cycle));
  return own;
}

// One [[take]]: a file that `files` found, or another one.
void read_take(const TomlTable& table, const fs::path& folder, Recipe& recipe,
               std::vector<std::string>& named) {
  const std::string file = table.required_text("file");
  const auto style = table.text("style");
  TakeSource own = read_own(table);
  own.load = read_load(table, folder);
  const bool used = table.boolean("use").value_or(true);
  if (file.empty()) return;
  own.place = table.place();
  own.label = fs::path(file).lexically_normal().generic_string();
  own.file = (folder / file).lexically_normal().string();
  if (std::find(named.begin(), named.end(), own.label) != named.end()) {
    table.error("file", "\"" + file + "\" has a [[take]] already; give it several [[take.cycle]]");
  }
  named.push_back(own.label);
  std::error_code error;
  if (used && !fs::is_regular_file(own.file, error)) {
    table.error("file", "there is no file " + own.file);
  }
  const auto found = std::find_if(recipe.takes.begin(), recipe.takes.end(),
                                  [&](const TakeSource& take) { return take.label == own.label; });
  own.style = style                         ? *style
              : found != recipe.takes.end() ? found->style
                                            : fs::path(file).stem().string();
  if (own.style.empty()) table.error("style", "\"style\" must not be empty");
  std::vector<TakeSource>& list = used ? recipe.takes : recipe.left_out;
  if (found != recipe.takes.end() && used) {
    *found = std::move(own);
  } else {
    if (found != recipe.takes.end()) recipe.takes.erase(found);
    list.push_back(std::move(own));
  }
}

// The files of the pattern but for those that `without` names.
void find_takes(const TomlTable& root, const fs::path& folder, const std::string& pattern,
                Recipe& recipe) {
  std::vector<FoundFile> found = find_files(folder, pattern);
  for (const TomlText& without : root.texts("without")) {
    const std::string trouble = trouble_with_pattern(without.text);
    if (!trouble.empty()) root.reader().add(without.place, trouble);
    const auto left = std::remove_if(found.begin(), found.end(), [&](const FoundFile& file) {
      return style_of(file.path, without.text).has_value();
    });
    if (left == found.end() && trouble.empty()) {
      root.reader().add(without.place, "no file that `files` finds fits \"" + without.text + "\"",
                        Severity::warning);
    }
    found.erase(left, found.end());
  }
  if (found.empty()) {
    root.error(root.has("files") ? "files" : "folder",
               "no file in " + folder.string() + " fits \"" + pattern + "\"");
  }
  for (const FoundFile& file : found) {
    recipe.takes.push_back({(folder / file.path).string(), file.path, file.style});
  }
}

// Keys that mean nothing without a folder or files are known all the same, and what is
// wrong with them is said.
void know_the_rest(const TomlTable& root) {
  root.texts("without");
  root.text("asf");
  root.number("frames_per_second", 1, 1000);
  for (const TomlTable& take : root.tables("take")) {
    read_own(take);
    take.required_text("file");
    for (const char* key : {"style", "asf"}) take.text(key);
    take.boolean("use");
  }
  if (const auto cuts = root.table("cuts")) {
    for (const char* key : {"file", "style", "from", "to"}) cuts->required_text(key);
  }
}

void read_takes(const TomlTable& root, const fs::path& folder, Recipe& recipe) {
  const auto files = root.text("files");
  const std::vector<TomlTable> tables = root.tables("take");
  std::error_code error;
  if (!root.reader().whole()) {  // what was left out may be the folder, or half of the takes
    return know_the_rest(root);
  }
  if (!fs::is_directory(folder, error)) {
    root.error("folder",
               "there is no folder " + folder.string() + "; give another one with --folder DIR");
    return know_the_rest(root);
  }
  const std::string pattern = files.value_or("*.bvh");
  const std::string trouble = trouble_with_pattern(pattern);
  if (!trouble.empty()) {
    root.error("files", trouble);
    return know_the_rest(root);
  }
  if (files || tables.empty()) find_takes(root, folder, pattern, recipe);
  std::vector<std::string> named;
  for (const TomlTable& table : tables) read_take(table, folder, recipe, named);
  const motion::LoadOptions load = read_load(root, folder);
  for (TakeSource& take : recipe.takes) {
    if (take.load.skeleton.empty()) take.load.skeleton = load.skeleton;
    if (!take.load.rate) take.load.rate = load.rate;
  }
  if (const auto cuts = root.table("cuts")) apply_cuts(*cuts, folder, recipe.takes);
  std::sort(recipe.takes.begin(), recipe.takes.end(),
            [](const TakeSource& a, const TakeSource& b) { return a.label < b.label; });
}

// Key phases of cycles that are given: named in the recipe, or evenly spaced.
void read_key_phases(const TomlTable& root, Recipe& recipe) {
  std::vector<double> phases = root.numbers("key_phases");
  if (recipe.options.walk) {
    if (!phases.empty()) root.error("key_phases", "are those of a walk; say motion = \"other\"");
    return;
  }
  if (phases.empty()) {
    const auto first = std::find_if(recipe.takes.begin(), recipe.takes.end(),
                                    [](const TakeSource& take) { return !take.cycles.empty(); });
    const std::size_t steps = first == recipe.takes.end()
                                  ? 1
                                  : std::max<std::size_t>(first->cycles[0].frames.size(), 2) - 1;
    for (std::size_t k = 0; k <= steps; ++k) {
      phases.push_back(static_cast<double>(k) / static_cast<double>(steps));
    }
  }
  const bool whole = phases.size() >= 2 && phases.front() == 0 && phases.back() == 1;
  if (!whole ||
      std::adjacent_find(phases.begin(), phases.end(), std::greater_equal<>()) != phases.end()) {
    root.error("key_phases", "must ascend from 0 to 1");
  }
  recipe.options.key_phases = std::move(phases);
}

// Given cycles need as many keytimes as the set has, and so do those that are found.
void check_cycles(const TomlTable& root, const Recipe& recipe) {
  const std::size_t keys = recipe.options.walk ? walk_keys : recipe.options.key_phases.size();
  for (const TakeSource& take : recipe.takes) {
    if (take.cycles.empty() && !recipe.options.walk && keys > 2) {
      const std::string message = take.label +
                                  " needs a [[take.cycle]]: keytimes of other motions than walks "
                                  "cannot be found, only loops without any between";
      if (take.place.line > 0) {
        root.reader().add(take.place, message);
      } else {
        root.error("files", message);
      }
    }
    for (const GivenCycle& cycle : take.cycles) {
      if (cycle.frames.size() == keys) continue;
      root.reader().add(
          cycle.place,
          "the cycle needs " + std::to_string(keys - 2) + " keytimes between first and last" +
              (recipe.options.walk ? ": right foot on, left off, left on" : " as the others have"));
    }
  }
}

void check_skeleton(const TomlTable& root, Recipe& recipe) {
  recipe.options.skeleton = root.text("skeleton").value_or("");
  if (recipe.options.skeleton.empty() || recipe.takes.empty()) return;
  const bool known =
      std::any_of(recipe.takes.begin(), recipe.takes.end(),
                  [&](const TakeSource& take) { return take.label == recipe.options.skeleton; });
  if (!known) root.error("skeleton", "is not one of the files that the recipe uses");
}

void read_options(const TomlTable& root, motion::SetOptions& options) {
  options.cycles_per_take = static_cast<int>(root.integer("cycles_per_take", 1, 20).value_or(1));
  options.search.most_loop_error_m = root.number("most_loop_error_m", 0, 1).value_or(0.15);
  if (const auto degrees = root.number("most_turn_deg", 0, 180)) {
    options.search.most_turn = *degrees * motion::pi / 180;
  }
  options.figure = read_figure(root);
  options.walk = root.choice("motion", {"walk", "other"}).value_or("walk") == "walk";
}

}  // namespace

Recipe load_recipe(const std::string& file, const std::string& folder) {
  const std::string text = read_file(file);
  TomlReader reader(file, text);
  const TomlTable root = reader.root();
  Recipe recipe;
  recipe.options.recipe = file;
  recipe.options.name = root.required_text("name");
  recipe.options.credit = root.required_text("credit");
  const std::string own_folder = root.required_text("folder");
  read_options(root, recipe.options);
  const fs::path place =
      (folder.empty() ? fs::path(file).parent_path() / own_folder : fs::path(folder))
          .lexically_normal();
  recipe.folder = place.string();
  read_takes(root, place, recipe);
  read_key_phases(root, recipe);
  check_cycles(root, recipe);
  check_skeleton(root, recipe);
  reader.finish();
  return recipe;
}

void hash_takes(Recipe& recipe, const std::function<void()>& progress) {
  std::vector<Problem> problems;
  for (TakeSource& take : recipe.takes) {
    if (progress) progress();
    try {
      take.sha256 = sha256_hex(read_file(take.file));
    } catch (const InputError& error) {
      problems.insert(problems.end(), error.problems().begin(), error.problems().end());
    }
  }
  if (!problems.empty()) throw InputError(problems);
}

}  // namespace promenade::study
