// `promenade set`: from captures to a motion set, what is in one, and out again.
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cctype>
#include <cstdio>
#include <memory>
#include <nlohmann/json.hpp>
#include <set>

#include "app/commands.h"
#include "motion/bvh.h"
#include "motion/cycle_clip.h"
#include "motion/files.h"
#include "motion/set_file.h"
#include "study/recipe.h"
#include "study/study.h"

namespace promenade::app {
namespace {

using Json = nlohmann::ordered_json;

void print(const std::string& text) { std::fwrite(text.data(), 1, text.size(), stdout); }

void print(const Json& document) {
  print(document.dump(2, ' ', false, nlohmann::detail::error_handler_t::replace) + "\n");
}

std::string table_row(const motion::MotionSet& set, const motion::CycleReport& report) {
  if (report.cycle.empty()) return fmt::format("refused: {}: {}\n", report.file, report.refusal);
  const int index = motion::find_cycle(set, report.cycle);
  const motion::Cycle& cycle = set.cycles[static_cast<std::size_t>(index)];
  return fmt::format("{:20} {:36} {:7} {:6} {:7.3f} {:7.1f} {:7.1f} {:6.1f} {:6.1f} {:7.1f}\n",
                     cycle.name, cycle.source, cycle.first_frame, cycle.frames, cycle.seconds,
                     1e3 * report.seam.gap_m, 1e3 * report.seam.inside_m,
                     1e3 * std::max(report.slide_left_m, report.slide_right_m),
                     1e3 * cycle.loop_error_m, 1e3 * report.from_capture_m);
}

std::string table(const motion::BuiltSet& built) {
  std::string text = fmt::format("{:20} {:36} {:>7} {:>6} {:>7} {:>7} {:>7} {:>6} {:>6} {:>7}\n",
                                 "cycle", "source", "first", "frames", "seconds", "seam", "inside",
                                 "slide", "loop", "moved");
  for (const motion::CycleReport& report : built.reports) text += table_row(built.set, report);
  text += fmt::format(
      "{} cycles of {} joints. seam, inside: largest jump of a joint in 1/60 s, at "
      "the seam and elsewhere; slide: of a standing foot;\nloop: gap before it was "
      "closed; moved: largest change of a joint from the capture; all in mm\n",
      built.set.size(), built.set.skeleton.size());
  return text;
}

Json report_json(const motion::BuiltSet& built) {
  Json list = Json::array();
  for (const motion::CycleReport& report : built.reports) {
    if (report.cycle.empty()) {
      list.push_back({{"source", report.file}, {"refusal", report.refusal}});
      continue;
    }
    list.push_back({{"source", report.file},
                    {"cycle", report.cycle},
                    {"seam_m", report.seam.gap_m},
                    {"inside_m", report.seam.inside_m},
                    {"slide_left_m", report.slide_left_m},
                    {"slide_right_m", report.slide_right_m},
                    {"moved_m", report.from_capture_m},
                    {"lowered_m", report.plant.lowered_m},
                    {"speed_change", report.plant.speed_change}});
  }
  return list;
}

// Takes can be long: a terminal is told which one is read.
class Progress {
 public:
  explicit Progress(std::size_t total) : total_(total), shown_(::isatty(STDERR_FILENO) == 1) {}
  void operator()(const motion::TakeSource& take) {
    ++done_;
    if (shown_)
      std::fprintf(stderr, "\r\033[Kreading %zu of %zu: %s", done_, total_, take.label.c_str());
  }
  void end() const {
    if (shown_) std::fputs("\r\033[K", stderr);
  }

 private:
  std::size_t total_, done_ = 0;
  bool shown_;
};

struct BuildArguments {
  std::string recipe, out, folder;
  bool json = false;
};

void build(const BuildArguments& given) {
  const study::Recipe recipe = study::load_recipe(given.recipe, given.folder);
  const auto progress = std::make_shared<Progress>(recipe.takes.size());
  const motion::BuiltSet built =
      motion::build_set(recipe.takes, recipe.options,
                        [progress](const motion::TakeSource& take) { (*progress)(take); });
  progress->end();
  for (const Problem& warning : built.warnings) {
    std::fprintf(stderr, "%s\n", to_text(warning).c_str());
  }
  write_file(given.out, motion::to_bytes(built.set));
  if (given.json) return print(report_json(built));
  print(table(built));
}

Json vector_json(const Eigen::Vector3d& v) { return {v.x(), v.y(), v.z()}; }

Json skeleton_json(const motion::MotionSet& set) {
  Json joints = Json::array(), ends = Json::array(), body = Json::object();
  const auto name = [&set](int joint) {
    return joint < 0 ? Json() : Json(set.skeleton.joints[static_cast<std::size_t>(joint)].name);
  };
  for (const motion::Joint& joint : set.skeleton.joints) {
    joints.push_back({{"name", joint.name},
                      {"parent", name(joint.parent)},
                      {"offset", vector_json(joint.offset)}});
  }
  for (const motion::EndSite& site : set.skeleton.end_sites) {
    ends.push_back({{"joint", name(site.joint)}, {"offset", vector_json(site.offset)}});
  }
  for (std::size_t b = 0; b < motion::body_joint_count; ++b) {
    const auto part = motion::body_joint_name(static_cast<motion::BodyJoint>(b));
    body[std::string(part)] = name(set.body.joint[b]);
  }
  return {{"joints", joints}, {"end_sites", ends}, {"body", body}};
}

Json cycle_json(const motion::Cycle& cycle) {
  return {{"name", cycle.name},
          {"style", cycle.style},
          {"source", cycle.source},
          {"first_frame", cycle.first_frame},
          {"frames", cycle.frames},
          {"seconds", cycle.seconds},
          {"keytimes", cycle.keytimes},
          {"loop_error_m", cycle.loop_error_m},
          {"velocity", {cycle.velocity.x(), cycle.velocity.y()}}};
}

void show_info(const std::string& name, bool json) {
  const motion::MotionSet set = study::load_motion_set(name, "");
  if (!json) {
    print(fmt::format("{}: {} cycles, {} joints\n{}\n", set.name, set.size(), set.skeleton.size(),
                      set.credit));
    for (const motion::Cycle& cycle : set.cycles) {
      print(fmt::format("{:20} {:36} {:7.3f} s\n", cycle.name, cycle.source, cycle.seconds));
    }
    return;
  }
  Json cycles = Json::array();
  for (const motion::Cycle& cycle : set.cycles) cycles.push_back(cycle_json(cycle));
  print(Json{{"name", set.name},
             {"credit", set.credit},
             {"cycles", cycles},
             {"skeleton", skeleton_json(set)},
             {"phases", set.phases},
             {"key_phases", set.key_phases},
             {"unit", "m"}});
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

void export_set(const std::string& name, const std::string& folder) {
  const motion::MotionSet set = study::load_motion_set(name, "");
  std::set<std::string> taken;
  for (const motion::Cycle& cycle : set.cycles) {
    const auto path = std::filesystem::path(folder) / (safe_name(cycle.name, taken) + ".bvh");
    write_file(path, motion::bvh_text(motion::cycle_clip(set, cycle)));
  }
  std::fprintf(stderr, "%d cycles written to %s\n", set.size(), folder.c_str());
}

void add_build(CLI::App& set_command) {
  auto* command = set_command.add_subcommand("build", "Cut the cycles of a recipe's captures");
  const auto given = std::make_shared<BuildArguments>();
  command->add_option("recipe", given->recipe, "A recipe (.toml)")->required();
  command->add_option("--out", given->out, "The motion set to write")->required();
  command->add_option("--folder", given->folder, "Where the captures lie, if not where it says");
  command->add_flag("--json", given->json, "One JSON document on stdout");
  command->callback([given] { build(*given); });
}

void add_info(CLI::App& set_command) {
  struct Arguments {
    std::string set;
    bool json = false;
  };
  auto* command = set_command.add_subcommand("info", "What a motion set holds");
  const auto given = std::make_shared<Arguments>();
  command->add_option("set", given->set, "A file, or builtin:A")->required();
  command->add_flag("--json", given->json, "One JSON document on stdout");
  command->callback([given] { show_info(given->set, given->json); });
}

void add_export(CLI::App& set_command) {
  struct Arguments {
    std::string set, out;
  };
  auto* command = set_command.add_subcommand("export", "One BVH file for every cycle");
  const auto given = std::make_shared<Arguments>();
  command->add_option("set", given->set, "A file, or builtin:A")->required();
  command->add_option("--out", given->out, "The folder to write to")->required();
  command->callback([given] { export_set(given->set, given->out); });
}

}  // namespace

void add_set_command(CLI::App& program) {
  CLI::App* command = program.add_subcommand("set", "Build, look into and export motion sets");
  command->require_subcommand(1);
  add_build(*command);
  add_info(*command);
  add_export(*command);
}

}  // namespace promenade::app
