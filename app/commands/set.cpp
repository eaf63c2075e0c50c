// `promenade set`: from captures to a motion set, what is in one, and out again.
#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cstdio>
#include <memory>
#include <set>

#include "analysis/pictures/cycle_picture.h"
#include "app/commands.h"
#include "app/commands/set_report.h"
#include "app/print.h"
#include "motion/bvh.h"
#include "motion/cycle_clip.h"
#include "motion/files.h"
#include "motion/set_file.h"
#include "study/recipe.h"
#include "study/study.h"

namespace promenade::app {
namespace {

struct BuildArguments {
  std::string recipe, out, folder, pictures;
  bool json = false;
};

void show_info(const std::string& name, bool json) {
  const motion::MotionSet set = study::load_motion_set(name, "");
  if (json) return print_json(info_json(set));
  print_text(info_table(set));
}

// Names come from a file: they must not lead out of the folder.
std::string safe_name(const std::string& name, std::set<std::string>& taken) {
  std::string safe = name.substr(0, 200);
  for (char& c : safe) {
    const bool plain = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9');
    if (!plain && c != '-' && c != '_' && c != '.') c = '_';
  }
  if (safe.empty() || safe[0] == '.') safe.insert(0, 1, '_');
  std::string unique = safe;
  for (int copy = 2; !taken.insert(unique).second; ++copy)
    unique = safe + "_" + std::to_string(copy);
  return unique;
}

void write_pictures(const motion::BuiltSet& built, const std::string& folder) {
  std::set<std::string> taken;
  std::vector<NamedBytes> files;
  for (const motion::CycleReport& report : built.reports) {
    if (report.cycle.empty()) continue;
    files.push_back(
        {safe_name(report.cycle, taken) + ".svg", analysis::cycle_picture(built, report)});
  }
  write_files(folder, files);
  std::fprintf(stderr, "%d pictures written to %s\n", built.set.size(), folder.c_str());
}

// Counts what is done, and ends it when somebody wants that.
class Steps {
 public:
  Steps(std::string what, std::size_t count)
      : what_(std::move(what)), count_(static_cast<int>(count)) {}
  void next() {
    if (interrupted()) throw OutsideError("stopped before the set was built; nothing is written");
    show_progress(what_, ++done_, count_);
  }

 private:
  std::string what_;
  int count_, done_ = 0;
};

void build(const BuildArguments& given) {
  study::Recipe recipe = study::load_recipe(given.recipe, given.folder);
  Steps hashing("checksum of take", recipe.takes.size());
  study::hash_takes(recipe, [&] { hashing.next(); });
  recipe.options.keep_takes = !given.pictures.empty();
  Steps reading("reading take", recipe.takes.size());
  const motion::BuiltSet built = motion::build_set(
      recipe.takes, recipe.options, [&](const motion::TakeSource&) { reading.next(); });
  print_problems(built.warnings);
  write_file(given.out, motion::to_bytes(built.set));
  if (!given.pictures.empty()) write_pictures(built, given.pictures);
  if (given.json) return print_json(build_json(built));
  print_text(build_table(built));
}

void export_set(const std::string& name, const std::string& folder, int times) {
  const motion::MotionSet set = study::load_motion_set(name, "");
  std::set<std::string> taken;
  std::vector<NamedBytes> files;
  for (const motion::Cycle& cycle : set.cycles) {
    const motion::Clip clip = motion::repeated_clip(motion::cycle_clip(set, cycle), times);
    files.push_back({safe_name(cycle.name, taken) + ".bvh", motion::bvh_text(clip)});
  }
  write_files(folder, files);
  std::fprintf(stderr, "%d cycles written to %s%s\n", set.size(), folder.c_str(),
               times > 1 ? fmt::format(", each {} times in a row", times).c_str() : "");
}

void add_build(Command set_command) {
  Command command = set_command.add_subcommand("build", "Cut the cycles of a recipe's captures");
  const auto given = std::make_shared<BuildArguments>();
  command.add_option("recipe", given->recipe, "A recipe (.toml)").required();
  command.add_option("--out", given->out, "The motion set to write").required();
  command.add_option("--folder", given->folder, "Where the captures lie, if not where it says");
  command.add_option("--pictures", given->pictures,
                     "A folder for one picture (SVG) of every cycle: where it was found, how it "
                     "closes");
  command.add_flag("--json", given->json, "One JSON document on stdout");
  command.callback([given] { build(*given); });
}

void add_info(Command set_command) {
  struct Arguments {
    std::string set;
    bool json = false;
  };
  Command command = set_command.add_subcommand("info", "What a motion set holds");
  const auto given = std::make_shared<Arguments>();
  command.add_option("set", given->set, "A file, or builtin:A, B or N").required();
  command.add_flag("--json", given->json, "One JSON document on stdout");
  command.callback([given] { show_info(given->set, given->json); });
}

void add_export(Command set_command) {
  struct Arguments {
    std::string set, out;
    int times = 1;
  };
  Command command = set_command.add_subcommand("export", "One BVH file for every cycle");
  const auto given = std::make_shared<Arguments>();
  command.add_option("set", given->set, "A file, or builtin:A, B or N").required();
  command.add_option("--out", given->out, "The folder to write to").required();
  command.add_option("--times", given->times, "Each cycle so many times in a row, 1 to 100")
      .range(1, 100);
  command.callback([given] { export_set(given->set, given->out, given->times); });
}

}  // namespace

void add_set_command(Command program) {
  Command command = program.add_subcommand("set", "Build, look into and export motion sets");
  command.require_subcommand();
  add_build(command);
  add_info(command);
  add_export(command);
}

}  // namespace promenade::app
