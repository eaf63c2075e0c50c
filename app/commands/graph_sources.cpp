#include "app/commands/graph_sources.h"

#include <filesystem>

#include "app/print.h"
#include "motion/scanner.h"
#include "study/recipe.h"
#include "study/study.h"

namespace promenade::app {
namespace {

namespace fs = std::filesystem;

constexpr double set_rate = 60;  // frames a second of the cycles of a motion set

bool ends_in(const std::string& name, const char* ending) {
  return motion::same_word(fs::path(name).extension().string(), ending);
}

bool is_set(const std::string& name) {
  return name.rfind("builtin:", 0) == 0 || ends_in(name, ".set");
}

// "sad=walk.bvh": the style, then the file; without a style its name is that of the file.
motion::TakeSource capture(const std::string& name) {
  motion::TakeSource source;
  const std::size_t equals = fs::exists(name) ? std::string::npos : name.find('=');
  source.file = equals == std::string::npos ? name : name.substr(equals + 1);
  source.label = fs::path(source.file).filename().string();
  source.style =
      equals == std::string::npos ? fs::path(source.file).stem().string() : name.substr(0, equals);
  if (equals != std::string::npos &&
      (source.style.empty() || source.style.find(',') != std::string::npos)) {
    throw InputError(name, "begins with a label that is empty or has a comma; name it otherwise");
  }
  return source;
}

void alone(const GraphSources& sources, const std::string& name, const char* what) {
  if (sources.names.size() == 1) return;
  throw InputError(name, std::string("is ") + what + " and stands alone; name nothing beside it");
}

study::Recipe recipe_of(const GraphSources& sources) {
  for (const std::string& name : sources.names) {
    if (!ends_in(name, ".toml")) continue;
    alone(sources, name, "a recipe");
    return study::load_recipe(name, sources.folder);
  }
  study::Recipe recipe;
  for (const std::string& name : sources.names) recipe.takes.push_back(capture(name));
  recipe.options.name = recipe.takes.front().style;
  return recipe;
}

// Says how far it is, and ends it when somebody wants that.
void next_step(const std::string& what, int done, std::size_t count) {
  if (interrupted()) throw OutsideError("stopped before the graph was built; nothing is written");
  show_progress(what, done, static_cast<int>(count));
}

NamedGraphTakes load_captures(const GraphSources& sources) {
  study::Recipe recipe = recipe_of(sources);
  int hashed = 0, read = 0;
  study::hash_takes(recipe, [&] { next_step("checksum of take", ++hashed, recipe.takes.size()); });
  motion::GraphTakeOptions options;
  options.read = {recipe.options.recipe, recipe.options.figure};
  options.rate = sources.rate;
  motion::GraphTakes loaded = motion::load_graph_takes(
      recipe.takes, options,
      [&](const motion::TakeSource&) { next_step("reading take", ++read, recipe.takes.size()); });
  return {recipe.options.name, std::move(loaded.takes), std::move(loaded.warnings)};
}

}  // namespace

NamedGraphTakes load_graph_sources(const GraphSources& sources) {
  for (const std::string& name : sources.names) {
    if (!is_set(name)) continue;
    alone(sources, name, "a motion set");
    const motion::MotionSet set = study::load_motion_set(name, "");
    return {set.name, motion::takes_of_set(set, sources.rate.value_or(set_rate)), {}};
  }
  return load_captures(sources);
}

}  // namespace promenade::app
