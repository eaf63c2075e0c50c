// `promenade check`: reads everything that a study names, says all that is wrong,
// and how fair its targets are.
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "app/commands.h"
#include "app/ethics_page.h"
#include "app/print.h"
#include "app/registry.h"
#include "motion/files.h"
#include "study/reach_models.h"

namespace promenade::app {
namespace {

using study::StudyBundle;
using study::Target;
using study::Task;

constexpr double fair_ratio = 3;

struct InterfaceReach {
  std::string interface;
  study::Reach reach;
};

// What the interfaces of a task can do about one of its targets.
struct TargetReport {
  std::string task, target;
  bool practice = false;
  Place place;
  std::optional<double> threshold_m;
  double judged_by_m = 0;  // the threshold, or the automatic one
  std::vector<InterfaceReach> reaches;
};

// By the model of the interface; one that has none is tried as it is.
study::Reach reach_of(const StudyBundle& bundle, const study::ReachModels& models, const Task& task,
                      int interface, const Target& target, double judged_by_m) {
  const std::string& type = bundle.study.interfaces[static_cast<std::size_t>(interface)].type;
  if (const motion::ControlMap* map = study::find_map(models, type)) {
    return study::reach(models, *map, target, judged_by_m, task.distance);
  }
  return study::reach(bundle, interfaces(), task, interface, target, {.threshold_m = judged_by_m});
}

TargetReport report_target(const StudyBundle& bundle, const study::ReachModels& models,
                           const Task& task, const Target& target, bool practice) {
  TargetReport report{task.name,
                      target.name,
                      practice,
                      target.place,
                      task.threshold_m,
                      study::judged_threshold(bundle.space, task),
                      {}};
  for (const int index : task.interfaces) {
    const std::string& name = bundle.study.interfaces[static_cast<std::size_t>(index)].name;
    report.reaches.push_back(
        {name, reach_of(bundle, models, task, index, target, report.judged_by_m)});
  }
  return report;
}

int count_targets(const StudyBundle& bundle) {
  int count = 0;
  for (const Task& task : bundle.study.tasks) {
    if (task.kind != study::TaskKind::match) continue;
    count += static_cast<int>(task.practice.size() + task.targets.size());
  }
  return count;
}

// Thousands of targets take minutes.
void note_progress(const StudyBundle& bundle, int done, int count) {
  show_progress("targets checked:", done, count);
  if (!interrupted()) return;
  throw OutsideError(fmt::format("stopped after {} of {} targets of {}", done, count, bundle.file));
}

std::vector<TargetReport> report_targets(const StudyBundle& bundle) {
  std::vector<TargetReport> reports;
  const int count = count_targets(bundle);
  if (count == 0) return reports;
  const study::ReachModels models = study::make_reach_models(bundle);
  for (const Task& task : bundle.study.tasks) {
    for (const bool practice : {true, false}) {
      for (const Target& target : practice ? task.practice : task.targets) {
        if (!target.weights) continue;
        reports.push_back(report_target(bundle, models, task, target, practice));
        note_progress(bundle, static_cast<int>(reports.size()), count);
      }
    }
  }
  return reports;
}

using Sentences = std::vector<std::string>;

void warn_of_reach(const TargetReport& report, Sentences& warnings) {
  if (!report.threshold_m) return;
  for (const auto& [interface, reach] : report.reaches) {
    if (reach.best < *report.threshold_m) continue;
    warnings.push_back(fmt::format(
        "task \"{}\": with interface \"{}\" the target \"{}\" seems out of reach: the best D found "
        "is {:.4f} m, the threshold {:.4f} m",
        report.task, interface, report.target, reach.best, *report.threshold_m));
  }
}

// A share of 0 stands for less than one of the settings that were tried.
double share_of(const study::Reach& reach) {
  return std::max(reach.share_below, 0.5 / std::max(1, reach.settings));
}

void warn_of_shares(const TargetReport& report, Sentences& warnings) {
  if (!report.threshold_m || report.reaches.size() < 2) return;
  const auto less = [](const InterfaceReach& a, const InterfaceReach& b) {
    return share_of(a.reach) < share_of(b.reach);
  };
  const auto [low, high] = std::minmax_element(report.reaches.begin(), report.reaches.end(), less);
  if (share_of(high->reach) <= fair_ratio * share_of(low->reach)) return;
  warnings.push_back(fmt::format(
      "task \"{}\": by chance, target \"{}\" is met by {:.1f} % of the settings of \"{}\", but by "
      "{:.1f} % of those of \"{}\"; the task favours one interface",
      report.task, report.target, 100 * high->reach.share_below, high->interface,
      100 * low->reach.share_below, low->interface));
}

void add_warnings(StudyBundle& bundle, const std::vector<TargetReport>& reports) {
  for (const TargetReport& report : reports) {
    Sentences sentences;
    warn_of_reach(report, sentences);
    warn_of_shares(report, sentences);
    for (std::string& sentence : sentences) {
      bundle.warnings.push_back({bundle.file, report.place.line, report.place.column,
                                 std::move(sentence), Severity::warning});
    }
  }
}

Json report_json(const TargetReport& report) {
  Json json = {{"task", report.task},
               {"target", report.target},
               {"practice", report.practice},
               {"threshold_m", to_json(report.threshold_m)},
               {"judged_by_m", report.judged_by_m}};
  json["interfaces"] = Json::array();
  for (const auto& [interface, reach] : report.reaches) {
    json["interfaces"].push_back({{"name", interface},
                                  {"d_start", reach.start},
                                  {"d_best", reach.best},
                                  {"d_best_example", reach.best_example},
                                  {"share_below", reach.share_below},
                                  {"settings", reach.settings}});
  }
  return json;
}

Json study_json(const std::string& file, const std::vector<Problem>& problems) {
  Json json = {{"file", file}, {"ok", !has_error(problems)}};
  json["problems"] = Json::array();
  for (const Problem& problem : problems) json["problems"].push_back(to_json(problem));
  return json;
}

Json bundle_json(const StudyBundle& bundle, const std::vector<TargetReport>& reports) {
  Json json = study_json(bundle.file, bundle.warnings);
  json["name"] = bundle.study.name;
  json["version"] = bundle.study.version;
  json["sha256"] = bundle.sha256;
  json["set"] = {{"name", bundle.space.set.name},
                 {"cycles", bundle.space.set.size()},
                 {"sha256", bundle.set_sha256},
                 {"median_style_distance_m", study::median_style_distance(bundle.space)}};
  json["targets"] = Json::array();
  for (const TargetReport& report : reports) json["targets"].push_back(report_json(report));
  return json;
}

std::string task_line(const Task& task) {
  std::string line =
      fmt::format("task {}: {}", task.name, task.kind == study::TaskKind::match ? "match" : "find");
  line += task.limit_s ? fmt::format(", {} s", *task.limit_s) : ", no time limit";
  if (task.threshold_m) {
    line += fmt::format(", won when D stays below {:.4f} m for {} s", *task.threshold_m,
                        static_cast<double>(task.dwell_us) / 1e6);
  }
  return line + "\n";
}

std::string targets_text(const std::vector<TargetReport>& reports) {
  std::string text = fmt::format("  {:<16}{:<16}{:<16}{:>10}{:>10}{:>14}{:>14}\n", "task", "target",
                                 "interface", "D start", "D best", "best example", "won by chance");
  for (const TargetReport& report : reports) {
    for (const auto& [interface, reach] : report.reaches) {
      text += fmt::format("  {:<16}{:<16}{:<16}{:>10.4f}{:>10.4f}{:>14.4f}", report.task,
                          report.target, interface, reach.start, reach.best, reach.best_example);
      text += report.threshold_m ? fmt::format("{:>12.1f} %\n", 100 * reach.share_below) : "\n";
    }
  }
  return text;
}

std::string bundle_text(const StudyBundle& bundle, const std::vector<TargetReport>& reports) {
  const study::Study& study = bundle.study;
  std::string text = fmt::format("{}: the study \"{}\", version {}, can be run\n", bundle.file,
                                 study.name, study.version);
  text += fmt::format("  {} interfaces, {} tasks; motion set {} with {} walks, {:.4f} m apart\n",
                      study.interfaces.size(), study.tasks.size(), study.set,
                      bundle.space.set.size(), study::median_style_distance(bundle.space));
  for (const Task& task : study.tasks) text += "  " + task_line(task);
  return reports.empty() ? text : text + targets_text(reports);
}

// Nothing is written for a study that cannot be run.
void write_ethics_page(const StudyBundle& bundle, const std::string& file) {
  if (file.empty()) return;
  const bool html = std::filesystem::path(file).extension() == ".html";
  write_file(file, ethics_page(bundle, html ? PageFormat::html : PageFormat::markdown));
}

void refuse_odd_page(const std::vector<std::string>& files, const std::string& ethics) {
  if (ethics.empty()) return;
  const std::string ending = std::filesystem::path(ethics).extension();
  if (ending != ".html" && ending != ".md") {
    throw InputError("--ethics " + ethics, "must end in .html or .md");
  }
  if (files.size() > 1) throw InputError("--ethics " + ethics, "is about one study; name only that");
}

void run(const std::vector<std::string>& files, const std::string& ethics, bool json) {
  refuse_odd_page(files, ethics);
  Json document = {{"studies", Json::array()}};
  std::vector<Problem> errors;
  interrupted();  // from now on Ctrl-C is seen between two targets
  for (const std::string& file : files) {
    try {
      StudyBundle bundle = study::load_study(file, interfaces());
      const std::vector<TargetReport> reports = report_targets(bundle);
      add_warnings(bundle, reports);
      print_problems(bundle.warnings);
      write_ethics_page(bundle, ethics);
      document["studies"].push_back(bundle_json(bundle, reports));
      if (!json) print_text(bundle_text(bundle, reports));
    } catch (const InputError& error) {
      errors.insert(errors.end(), error.problems().begin(), error.problems().end());
      document["studies"].push_back(study_json(file, error.problems()));
    }
  }
  if (json) print_json(document);
  if (!errors.empty()) throw InputError(errors);
}

}  // namespace

void add_check_command(CLI::App& program) {
  auto files = std::make_shared<std::vector<std::string>>();
  auto ethics = std::make_shared<std::string>();
  auto json = std::make_shared<bool>(false);
  CLI::App* command = program.add_subcommand("check", "Reads everything a study names");
  command->add_option("studies", *files, "study files (.toml)")->required();
  command->add_option("--ethics", *ethics,
                      "a page for an ethics board to write (.html or .md): what is asked and "
                      "stored, and how people withdraw");
  command->add_flag("--json", *json, "one JSON document on stdout");
  command->callback([files, ethics, json] { run(*files, *ethics, *json); });
}

}  // namespace promenade::app
