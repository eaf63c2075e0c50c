// `promenade check`: reads everything that a study names, says all that is wrong,
// how fair its targets are, and how long a session takes.
#include <fmt/format.h>

#include <cmath>
#include <filesystem>

#include "app/commands.h"
#include "app/commands/target_report.h"
#include "app/ethics_page.h"
#include "app/print.h"
#include "app/registry.h"
#include "motion/files.h"
#include "motion/models/adjective_pairs.h"
#include "study/asked_quality.h"
#include "study/plan.h"
#include "study/session_length.h"
#include "study/stimulus.h"

namespace promenade::app {
namespace {

using study::StudyBundle;
using study::Task;
using study::TaskKind;

constexpr int timed_people = 5;

// What is told of a study that can be run.
struct Report {
  std::vector<TargetReport> targets;
  study::SessionLength length;
};

study::SessionLength length_of(const StudyBundle& bundle) {
  int done = 0;
  const auto length = study::session_length(bundle, interfaces(), timed_people, [&] {
    show_progress("sessions timed:", ++done, timed_people);
    return !interrupted();
  });
  show_progress("sessions timed:", timed_people, timed_people);
  if (interrupted())
    throw OutsideError("stopped while the sessions of " + bundle.file + " were timed");
  return length;
}

void warn_of_length(StudyBundle& bundle, double minutes) {
  const double most = bundle.study.most_minutes;
  if (minutes <= most) return;
  bundle.warnings.push_back(
      {bundle.file, 0, 0,
       fmt::format("a session takes about {:.0f} minutes, more than the {} of \"most_minutes\"; "
                   "leave something out, or tell people before",
                   std::ceil(minutes), most),
       Severity::warning});
}

Report report_study(StudyBundle& bundle) {
  Report report{report_targets(bundle), length_of(bundle)};
  for (Problem& warning : warnings_of(bundle.file, report.targets)) {
    bundle.warnings.push_back(std::move(warning));
  }
  warn_of_length(bundle, report.length.median);
  return report;
}

Json study_json(const std::string& file, const std::vector<Problem>& problems) {
  Json json = {{"file", file}, {"ok", !has_error(problems)}};
  json["problems"] = Json::array();
  for (const Problem& problem : problems) json["problems"].push_back(to_json(problem));
  return json;
}

Json stimulus_json(const study::Stimulus& stimulus) {
  Json parts = Json::array();
  for (const motion::LabelledPart& part : stimulus.labels) {
    parts.push_back({{"label", part.label},
                     {"from_s", part.from * stimulus.take.frame_time},
                     {"to_s", part.to * stimulus.take.frame_time}});
  }
  return {{"name", stimulus.name},
          {"graph", stimulus.file},
          {"seconds", stimulus.seconds()},
          {"transitions", study::count_transitions(stimulus)},
          {"parts", std::move(parts)}};
}

Json bundle_json(const StudyBundle& bundle, const Report& report) {
  Json json = study_json(bundle.file, bundle.warnings);
  json["name"] = bundle.study.name;
  json["version"] = bundle.study.version;
  json["sha256"] = bundle.sha256;
  json["set"] = {{"name", bundle.space.set.name},
                 {"cycles", bundle.space.set.size()},
                 {"sha256", bundle.set_sha256},
                 {"median_style_distance_m", study::median_style_distance(bundle.space)}};
  json["targets"] = Json::array();
  for (const TargetReport& target : report.targets) json["targets"].push_back(to_json(target));
  json["stimuli"] = Json::array();
  for (const auto& one : bundle.study.stimuli) json["stimuli"].push_back(stimulus_json(*one));
  json["minutes"] = report.length.median;
  json["minutes_range"] = {report.length.least, report.length.most};
  json["round"] = study::round_of_design(bundle.study);
  return json;
}

const char* kind_word(TaskKind kind) {
  switch (kind) {
    case TaskKind::match:
      return "match";
    case TaskKind::find:
      return "find";
    case TaskKind::guess:
      return "guess";
    case TaskKind::rate:
      return "rate";
  }
  return "";
}

std::string task_line(const study::Study& study, const Task& task) {
  std::string line = fmt::format("task {}: {}", task.name, kind_word(task.kind));
  line += task.limit_s ? fmt::format(", {} s", *task.limit_s) : ", no time limit";
  if (task.threshold_m && task.kind == TaskKind::match) {
    line += fmt::format(", won when D stays below {:.4f} m for {} s", *task.threshold_m,
                        static_cast<double>(task.dwell_us) / 1e6);
  }
  if (task.start_guess >= 0) {
    line += ", from the guess of " + study.tasks[static_cast<std::size_t>(task.start_guess)].name;
  }
  if (task.split) {
    line +=
        fmt::format(", {} of {} motions by each person", task.split->each(), task.split->motions());
    if (task.repeats > 0) line += fmt::format(", {} of them twice", task.repeats);
  }
  if (!task.lists.empty()) line += fmt::format(", targets in {} lists", task.lists.size());
  return line + "\n";
}

// Which pair of adjectives scores what is found, and which of its ends.
std::string qualities_text(const StudyBundle& bundle, const Task& task) {
  const auto model = study::rated_adjectives(bundle);
  const std::vector<std::string> pairs = model ? model->table.pairs : std::vector<std::string>();
  std::string text;
  for (const study::Target& target : task.targets) {
    const std::optional<study::AskedPair> asked = study::asked_pair(pairs, target);
    text += "    quality " + target.name + ": ";
    if (!asked) {
      text += "no pair of adjectives scores it\n";
      continue;
    }
    const std::string& pair = pairs[static_cast<std::size_t>(asked->pair)];
    const motion::PairWords words = motion::words_of_pair(pair);
    text += fmt::format("scored as \"{}\", by the ratings of {}\n",
                        asked->left ? words.left : words.right, pair);
  }
  return text;
}

// "stimulus happy_then_sad: 8.1 s of walks.graph: happy 4.1 s, sad 4.0 s, 3 transitions"
std::string stimuli_text(const StudyBundle& bundle) {
  std::string text;
  for (const auto& one : bundle.study.stimuli) {
    const bool alike = study::same_bones(one->take.skeleton, bundle.space.set.skeleton);
    const int transitions = study::count_transitions(*one);
    text += fmt::format("  stimulus {}: {:.1f} s of {}: {}, {} transition{}{}\n", one->name,
                        one->seconds(), one->file, study::describe_parts(*one), transitions,
                        transitions == 1 ? "" : "s", alike ? "" : "; a figure of its own");
  }
  return text;
}

std::string bundle_text(const StudyBundle& bundle, const Report& report) {
  const study::Study& study = bundle.study;
  std::string text = fmt::format("{}: the study \"{}\", version {}, can be run\n", bundle.file,
                                 study.name, study.version);
  text += fmt::format("  {} interface{}, {} task{}; motion set {} with {} walks, {:.4f} m apart\n",
                      study.interfaces.size(), study.interfaces.size() == 1 ? "" : "s",
                      study.tasks.size(), study.tasks.size() == 1 ? "" : "s", study.set,
                      bundle.space.set.size(), study::median_style_distance(bundle.space));
  text += fmt::format(
      "  a session takes about {:.0f} minutes; numbers of participants that are a "
      "multiple of {} are balanced\n",
      std::ceil(report.length.median), study::round_of_design(study));
  for (const Task& task : study.tasks) {
    text += "  " + task_line(study, task);
    if (task.kind == TaskKind::find) text += qualities_text(bundle, task);
  }
  text += stimuli_text(bundle);
  return report.targets.empty() ? text : text + targets_text(report.targets);
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
  if (files.size() > 1)
    throw InputError("--ethics " + ethics, "is about one study; name only that");
}

void run(const std::vector<std::string>& files, const std::string& ethics, bool json) {
  refuse_odd_page(files, ethics);
  Json document = {{"studies", Json::array()}};
  std::vector<Problem> errors;
  interrupted();  // from now on Ctrl-C is seen between two targets
  for (const std::string& file : files) {
    try {
      StudyBundle bundle = study::load_study(file, interfaces());
      const Report report = report_study(bundle);
      print_problems(bundle.warnings);
      write_ethics_page(bundle, ethics);
      document["studies"].push_back(bundle_json(bundle, report));
      if (!json) print_text(bundle_text(bundle, report));
    } catch (const InputError& error) {
      errors.insert(errors.end(), error.problems().begin(), error.problems().end());
      document["studies"].push_back(study_json(file, error.problems()));
    }
  }
  if (json) print_json(document);
  if (!errors.empty()) throw InputError(errors);
}

}  // namespace

void add_check_command(Command program) {
  auto files = std::make_shared<std::vector<std::string>>();
  auto ethics = std::make_shared<std::string>();
  auto json = std::make_shared<bool>(false);
  Command command = program.add_subcommand("check", "Reads everything a study names");
  command.add_option("studies", *files, "study files (.toml)").required();
  command.add_option("--ethics", *ethics,
                     "a page for an ethics board to write (.html or .md): what is asked and "
                     "stored, and how people withdraw");
  command.add_flag("--json", *json, "one JSON document on stdout");
  command.callback([files, ethics, json] { run(*files, *ethics, *json); });
}

}  // namespace promenade::app
