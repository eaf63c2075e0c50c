// [[stimulus]]: motions out of motion graphs, to be rated.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "motion/did_you_mean.h"
#include "motion/graph/graph_file.h"
#include "motion/graph/graph_labels.h"
#include "study/stimulus.h"
#include "study/study_parts.h"

namespace promenade::study {
namespace {

constexpr double shortest_part_s = 0.1, longest_part_s = 600;
constexpr double least_miss_s = 0.5, most_miss = 0.25;  // that is worth a warning: s, share
constexpr std::int64_t largest_seed = INT64_MAX;

using Graph = std::shared_ptr<const motion::MotionGraph>;

// Reads every graph once, and says once what is wrong with it.
class GraphShelf {
 public:
  explicit GraphShelf(StudyFiles& files) : files_(files) {}

  // Null after a problem.
  Graph find(const TomlTable& table, const std::string& name) {
    if (name.empty()) return nullptr;
    const auto known = graphs_.find(name);
    if (known != graphs_.end()) return known->second;
    return graphs_[name] = read(table, name);
  }

 private:
  Graph read(const TomlTable& table, const std::string& name) {
    try {
      auto graph = std::make_shared<motion::MotionGraph>(
          motion::graph_from_bytes(files_.read(name), files_.full_path(name)));
      if (!graph->edges.empty()) return graph;
      table.error("graph", "there is no walk in the motion graph \"" + name + "\"");
    } catch (const InputError& error) {
      add_file_problems(table, "graph", "the motion graph \"" + name + "\"", error);
    }
    return nullptr;
  }

  StudyFiles& files_;
  std::map<std::string, Graph> graphs_;
};

// A name that stands for a motion in the results must stand for that alone.
void refuse_names_of_walks(const TomlTable& table, const std::string& name,
                           const StudyContext& context) {
  if (!context.space) return;
  const auto& cycles = context.space->set.cycles;
  const bool taken = std::any_of(cycles.begin(), cycles.end(), [&](const motion::Cycle& one) {
    return one.name == name || one.style == name;
  });
  if (!taken) return;
  table.error("name", "the motion set has a walk \"" + name +
                          "\"; results could not tell the two "
                          "apart, so take another name");
}

motion::WantedLabel read_part(const TomlTable& table, const Graph& graph, const std::string& file) {
  motion::WantedLabel part{table.required_text("label"), 0};
  table.require("seconds");
  part.seconds = table.number("seconds", shortest_part_s, longest_part_s).value_or(0);
  if (!graph || part.label.empty()) return part;
  const std::vector<std::string> labels = motion::edge_labels(*graph);
  if (std::find(labels.begin(), labels.end(), part.label) != labels.end()) return part;
  table.error("label", "the motion graph \"" + file + "\" has no label \"" + part.label + "\"" +
                           did_you_mean(part.label, labels));
  part.label.clear();
  return part;
}

// All of them, or none after a problem.
std::vector<motion::WantedLabel> read_parts(const TomlTable& table, const Graph& graph,
                                            const std::string& file) {
  std::vector<motion::WantedLabel> parts;
  bool good = true;
  for (const TomlTable& one : table.tables("parts")) {
    parts.push_back(read_part(one, graph, file));
    good = good && !parts.back().label.empty() && parts.back().seconds > 0;
  }
  if (!table.has("parts")) {
    table.error(R"(a stimulus needs "parts", as [{ label = "happy", seconds = 4 }])");
  } else if (parts.empty() && table.is("parts", TomlValue::Kind::array)) {
    table.error("parts", "\"parts\" must not be empty");
  }
  return good ? parts : std::vector<motion::WantedLabel>();
}

// Seconds of each label.
std::map<std::string, double> seen_in(const Stimulus& stimulus) {
  std::map<std::string, double> seconds;
  for (const motion::LabelledPart& part : stimulus.labels) {
    seconds[part.label] += (part.to - part.from) * stimulus.take.frame_time;
  }
  return seconds;
}

// A graph may have no walk that comes near to what is asked.
void warn_of_other_seconds(const TomlTable& table, const std::vector<motion::WantedLabel>& parts,
                           const Stimulus& stimulus) {
  std::map<std::string, double> asked, seen = seen_in(stimulus);
  for (const motion::WantedLabel& part : parts) asked[part.label] += part.seconds;
  for (const auto& [label, seconds] : seen) asked[label] += 0;
  for (const auto& [label, seconds] : asked) {
    if (std::abs(seen[label] - seconds) <= std::max(least_miss_s, most_miss * seconds)) continue;
    table.warning("parts", fmt::format("\"{}\" is seen for {:.1f} s, not for the {:.1f} s that are "
                                       "asked for: the graph has no better walk",
                                       label, seen[label], seconds));
  }
}

std::shared_ptr<const Stimulus> read_stimulus(const TomlTable& table, const StudyContext& context,
                                              GraphShelf& graphs) {
  const std::string name = read_name(table);
  refuse_names_of_walks(table, name, context);
  const std::string file = table.required_text("graph");
  const Graph graph = graphs.find(table, file);
  std::vector<motion::WantedLabel> parts = read_parts(table, graph, file);
  const auto seed = static_cast<std::uint64_t>(table.integer("seed", 0, largest_seed).value_or(1));
  auto stimulus = std::make_shared<Stimulus>();
  stimulus->name = name;
  if (!graph || parts.empty()) return stimulus;
  try {
    *stimulus = make_stimulus(name, graph, find_walk(*graph, parts, seed));
    stimulus->file = file;
    warn_of_other_seconds(table, parts, *stimulus);
  } catch (const InputError& error) {
    for (const Problem& problem : error.problems()) table.error("parts", problem.message);
  }
  return stimulus;
}

const Stimulus* find_stimulus(const Study& study, const std::string& name) {
  for (const auto& one : study.stimuli) {
    if (one->name == name) return one.get();
  }
  return nullptr;
}

bool shows(const Task& task, const Stimulus& stimulus) {
  const auto is_it = [&](const Target& target) { return target.stimulus.get() == &stimulus; };
  return std::any_of(task.targets.begin(), task.targets.end(), is_it) ||
         std::any_of(task.practice.begin(), task.practice.end(), is_it);
}

const motion::Skeleton& skeleton_of(const Target& target, const motion::MotionSet& set) {
  return target.stimulus ? target.stimulus->take.skeleton : set.skeleton;
}

// People may rate the figure where they should rate how it moves.
void warn_of_other_bones(const TomlTable& root, const motion::MotionSet& set, const Task& task) {
  const motion::Skeleton* first = task.reference >= 0 ? &set.skeleton : nullptr;
  for (const auto* targets : {&task.targets, &task.practice}) {
    for (const Target& target : *targets) {
      const motion::Skeleton& bones = skeleton_of(target, set);
      if (first == nullptr) first = &bones;
      if (same_bones(bones, *first)) continue;
      root.reader().add(target.place,
                        "the figure of \"" + target.name +
                            "\" has other bones than others that people see in this task; its "
                            "looks may be rated with its motion",
                        Severity::warning);
    }
  }
}

}  // namespace

std::vector<std::shared_ptr<const Stimulus>> read_stimuli(const TomlTable& root,
                                                          const StudyContext& context) {
  GraphShelf graphs(context.files);
  std::vector<std::shared_ptr<const Stimulus>> stimuli;
  std::vector<std::string> names;
  const std::vector<TomlTable> tables = root.tables("stimulus");
  for (const TomlTable& table : tables) {
    stimuli.push_back(read_stimulus(table, context, graphs));
    names.push_back(stimuli.back()->name);
  }
  refuse_doubles(tables, names, "stimulus");
  return stimuli;
}

Target read_stimulus_target(const TomlTable& table, const StudyContext& context) {
  Target target;
  target.place = table.place();
  target.name = table.text("stimulus").value_or("");
  if (target.name.empty()) return target;
  std::vector<std::string> names;
  for (const auto& one : context.study.stimuli) {
    names.push_back(one->name);
    if (one->name == target.name) target.stimulus = one;
  }
  if (!target.stimulus && table.reader().whole()) {
    table.error("stimulus", "there is no [[stimulus]] with the name \"" + target.name + "\"" +
                                did_you_mean(target.name, names));
  }
  return target;
}

void warn_of_stimuli(const TomlTable& root, const motion::MotionSet& set, const Study& study) {
  for (const TomlTable& table : root.tables("stimulus")) {
    const Stimulus* stimulus = find_stimulus(study, table.text("name").value_or(""));
    const bool shown = stimulus && std::any_of(study.tasks.begin(), study.tasks.end(),
                                               [&](auto& task) { return shows(task, *stimulus); });
    if (stimulus && !shown) {
      table.warning("name", "no task shows the stimulus \"" + stimulus->name + "\"");
    }
  }
  for (const Task& task : study.tasks) warn_of_other_bones(root, set, task);
}

}  // namespace promenade::study
