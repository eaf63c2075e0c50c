// `promenade plan`: who gets what in which order.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "app/commands.h"
#include "app/print.h"
#include "app/registry.h"
#include "study/balance.h"

namespace promenade::app {
namespace {

using study::Plan;
using study::PlannedTrial;
using study::Study;
using study::StudyBundle;

struct Options {
  std::string file;
  int participants = 0;
  bool json = false;
};

const std::string& interface_name(const Study& study, int index) {
  static const std::string none = "-";  // in rate tasks
  return index < 0 ? none : study.interfaces[static_cast<std::size_t>(index)].name;
}

// What was drawn for this participant, by the names of the motions.
Json weights_json(const StudyBundle& bundle, const Eigen::VectorXd& weights) {
  Json json = Json::object();
  for (Eigen::Index i = 0; i < weights.size(); ++i) {
    const auto& cycle = bundle.space.set.cycles[static_cast<std::size_t>(i)];
    if (weights(i) != 0) json[cycle.name] = weights(i);
  }
  return json;
}

Json trial_json(const StudyBundle& bundle, const PlannedTrial& trial) {
  const Study& study = bundle.study;
  Json json = {{"position", trial.position}, {"block", trial.block},
               {"practice", trial.practice}, {"task", study::task_of(study, trial).name},
               {"interface", nullptr},       {"target", study::target_of(study, trial).name},
               {"showing", trial.showing}};
  if (trial.interface >= 0) json["interface"] = interface_name(study, trial.interface);
  if (trial.drawn.size() > 0) json["weights"] = weights_json(bundle, trial.drawn);
  return json;
}

// The list of each interface, from 1.
Json lists_json(const Study& study, int sequence) {
  Json json = Json::object();
  for (std::size_t t = 0; t < study.tasks.size(); ++t) {
    const study::Task& task = study.tasks[t];
    if (task.lists.empty()) continue;
    Json& lists = json[task.name] = Json::object();
    for (const int interface : task.interfaces) {
      const int list = study::list_of(study, static_cast<int>(t), interface, sequence);
      lists[interface_name(study, interface)] = list + 1;
    }
  }
  return json;
}

Json plan_json(const StudyBundle& bundle, const Plan& plan) {
  const Study& study = bundle.study;
  Json json = {{"sequence", plan.sequence}, {"seed", plan.seed}};
  json["interfaces"] = Json::array();
  for (const int interface : study::block_order(plan)) {
    json["interfaces"].push_back(interface_name(study, interface));
  }
  json["trials"] = Json::array();
  json["lists"] = lists_json(study, plan.sequence);
  for (const PlannedTrial& trial : plan.trials) json["trials"].push_back(trial_json(bundle, trial));
  return json;
}

// By task and target, where a task is split: how many people rate it.
Json ratings_json(const Study& study, const study::Balance& balance) {
  Json json = Json::object();
  for (std::size_t t = 0; t < study.tasks.size(); ++t) {
    const Eigen::VectorXi& counts = balance.ratings[t];
    if (counts.size() == 0) continue;
    Json& task = json[study.tasks[t].name] = Json::object();
    for (Eigen::Index i = 0; i < counts.size(); ++i) {
      task[study.tasks[t].targets[static_cast<std::size_t>(i)].name] = counts(i);
    }
  }
  return json;
}

Json balance_json(const Study& study, const study::Balance& balance) {
  Json positions = Json::object();
  Json carry_over = Json::object();
  const int n = static_cast<int>(study.interfaces.size());
  for (int i = 0; i < n; ++i) {
    Json& row = positions[interface_name(study, i)] = Json::array();
    Json& after = carry_over[interface_name(study, i)] = Json::object();
    for (int j = 0; j < n; ++j) {
      row.push_back(balance.position(i, j));
      after[interface_name(study, j)] = balance.carry_over(i, j);
    }
  }
  Json lists = Json::object();
  for (std::size_t t = 0; t < study.tasks.size(); ++t) {
    const Eigen::MatrixXi& counts = balance.lists[t];
    if (counts.size() == 0) continue;
    Json& table = lists[study.tasks[t].name] = Json::object();
    for (Eigen::Index r = 0; r < counts.rows(); ++r) {
      const int interface = study.tasks[t].interfaces[static_cast<std::size_t>(r)];
      Json& row = table[interface_name(study, interface)] = Json::array();
      for (const int count : counts.row(r)) row.push_back(count);
    }
  }
  return {{"position", positions},
          {"carry_over", carry_over},
          {"lists", lists},
          {"ratings", ratings_json(study, balance)},
          {"round", study::round_of_design(study)},
          {"even", balance.even}};
}

// "0.62 proud, 0.31 sad, ...": the largest three.
std::string drawn_text(const StudyBundle& bundle, const Eigen::VectorXd& weights) {
  std::vector<int> motions;
  for (int i = 0; i < weights.size(); ++i) motions.push_back(i);
  std::stable_sort(motions.begin(), motions.end(),
                   [&](int a, int b) { return std::abs(weights(a)) > std::abs(weights(b)); });
  std::string text;
  for (std::size_t i = 0; i < std::min<std::size_t>(3, motions.size()); ++i) {
    const auto& cycle = bundle.space.set.cycles[static_cast<std::size_t>(motions[i])];
    text += fmt::format("{}{:.2f} {}", i == 0 ? "" : ", ", weights(motions[i]), cycle.name);
  }
  return motions.size() > 3 ? text + ", ..." : text;
}

std::string trials_text(const StudyBundle& bundle, const Plan& plan) {
  const Study& study = bundle.study;
  std::string text = fmt::format("order {}\n", plan.sequence);
  for (const PlannedTrial& trial : plan.trials) {
    text += fmt::format("  {:>3}  {:<16} {:<16} {}{}{}\n", trial.position,
                        interface_name(study, trial.interface), study::task_of(study, trial).name,
                        study::target_of(study, trial).name,
                        trial.drawn.size() > 0 ? ": " + drawn_text(bundle, trial.drawn) : "",
                        trial.practice      ? "  (practice)"
                        : trial.showing > 1 ? "  (again)"
                                            : "");
  }
  return text;
}

// Which targets are in which list, and how often each interface gets it.
std::string lists_text(const Study& study, std::size_t index, const Eigen::MatrixXi& counts) {
  const study::Task& task = study.tasks[index];
  std::string text = fmt::format("\n{:<20}", "lists of " + task.name);
  for (std::size_t l = 0; l < task.lists.size(); ++l) text += fmt::format("{:>10}", l + 1);
  text += "\n";
  for (Eigen::Index r = 0; r < counts.rows(); ++r) {
    const int interface = task.interfaces[static_cast<std::size_t>(r)];
    text += fmt::format("  {:<18}", interface_name(study, interface));
    for (const int count : counts.row(r)) text += fmt::format("{:>10}", count);
    text += "\n";
  }
  for (std::size_t l = 0; l < task.lists.size(); ++l) {
    text += fmt::format("  {}:", l + 1);
    for (const int target : task.lists[l]) {
      text += " " + task.targets[static_cast<std::size_t>(target)].name;
    }
    text += "\n";
  }
  return text;
}

std::string ratings_text(const study::Task& task, const Eigen::VectorXi& counts) {
  std::string text = fmt::format("\nratings of {}\n", task.name);
  for (Eigen::Index i = 0; i < counts.size(); ++i) {
    text +=
        fmt::format("  {:<18}{:>10}\n", task.targets[static_cast<std::size_t>(i)].name, counts(i));
  }
  return text;
}

std::string counts_text(const Study& study, const Eigen::MatrixXi& counts, const std::string& title,
                        bool by_interface) {
  std::string text = fmt::format("\n{:<20}", title);
  for (Eigen::Index c = 0; c < counts.cols(); ++c) {
    const int column = static_cast<int>(c);
    text += fmt::format("{:>10}", by_interface ? interface_name(study, column)
                                               : fmt::format("place {}", column + 1));
  }
  text += "\n";
  for (Eigen::Index r = 0; r < counts.rows(); ++r) {
    text += fmt::format("  {:<18}", interface_name(study, static_cast<int>(r)));
    for (Eigen::Index c = 0; c < counts.cols(); ++c) text += fmt::format("{:>10}", counts(r, c));
    text += "\n";
  }
  return text;
}

void print_plain(const StudyBundle& bundle, const std::vector<Plan>& plans,
                 const study::Balance& balance) {
  const Study& study = bundle.study;
  for (const Plan& plan : plans) print_text(trials_text(bundle, plan));
  if (!study.interfaces.empty()) {
    print_text(counts_text(study, balance.position, "came in", false));
    print_text(counts_text(study, balance.carry_over, "came right before", true));
  }
  for (std::size_t t = 0; t < study.tasks.size(); ++t) {
    if (balance.lists[t].size() > 0) print_text(lists_text(study, t, balance.lists[t]));
    if (balance.ratings[t].size() > 0) print_text(ratings_text(study.tasks[t], balance.ratings[t]));
  }
  if (!balance.even) {
    print_text("\nThe design is not balanced for this number of participants.\n");
  }
}

void run(const Options& options) {
  const StudyBundle bundle = study::load_study(options.file, interfaces());
  print_problems(bundle.warnings);
  std::vector<Plan> plans;
  plans.reserve(static_cast<std::size_t>(options.participants));
  interrupted();  // from now on Ctrl-C is seen between two plans
  for (int i = 0; i < options.participants; ++i) {
    plans.push_back(study::make_plan(bundle.study, i));
    show_progress("orders made:", i + 1, options.participants);
    if (interrupted()) throw OutsideError("stopped before all orders were made");
  }
  const study::Balance balance = study::balance_of(bundle.study, plans);
  if (!options.json) return print_plain(bundle, plans, balance);
  Json json = {{"study", bundle.study.name},
               {"sha256", bundle.sha256},
               {"participants", options.participants}};
  json["sequences"] = Json::array();
  for (const Plan& plan : plans) json["sequences"].push_back(plan_json(bundle, plan));
  json["balance"] = balance_json(bundle.study, balance);
  print_json(json);
}

}  // namespace

void add_plan_command(Command program) {
  auto options = std::make_shared<Options>();
  Command command = program.add_subcommand("plan", "Who gets what in which order");
  command.add_option("study", options->file, "the study file (.toml or .study)").required();
  command.add_option("--participants", options->participants, "how many sessions to plan")
      .required()
      .range(1, 100'000);
  command.add_flag("--json", options->json, "one JSON document on stdout");
  command.callback([options] { run(*options); });
}

}  // namespace promenade::app
