// `promenade plan`: who gets what in which order.
#include <fmt/format.h>

#include "app/commands.h"
#include "app/print.h"
#include "app/registry.h"
#include "study/balance.h"

namespace promenade::app {
namespace {

using study::Plan;
using study::PlannedTrial;
using study::Study;

struct Options {
  std::string file;
  int participants = 0;
  bool json = false;
};

const std::string& interface_name(const Study& study, int index) {
  return study.interfaces[static_cast<std::size_t>(index)].name;
}

Json trial_json(const Study& study, const PlannedTrial& trial) {
  return {{"position", trial.position},
          {"block", trial.block},
          {"practice", trial.practice},
          {"task", study::task_of(study, trial).name},
          {"interface", interface_name(study, trial.interface)},
          {"target", study::target_of(study, trial).name}};
}

Json plan_json(const Study& study, const Plan& plan) {
  Json json = {{"sequence", plan.sequence}, {"seed", plan.seed}};
  json["interfaces"] = Json::array();
  for (const int interface : study::block_order(plan)) {
    json["interfaces"].push_back(interface_name(study, interface));
  }
  json["trials"] = Json::array();
  for (const PlannedTrial& trial : plan.trials) json["trials"].push_back(trial_json(study, trial));
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
  return {{"position", positions}, {"carry_over", carry_over}, {"even", balance.even}};
}

std::string trials_text(const Study& study, const Plan& plan) {
  std::string text = fmt::format("order {}\n", plan.sequence);
  for (const PlannedTrial& trial : plan.trials) {
    text += fmt::format("  {:>3}  {:<16} {:<16} {}{}\n", trial.position,
                        interface_name(study, trial.interface), study::task_of(study, trial).name,
                        study::target_of(study, trial).name, trial.practice ? "  (practice)" : "");
  }
  return text;
}

std::string counts_text(const Study& study, const Eigen::MatrixXi& counts, const std::string& title,
                        bool by_interface) {
  std::string text = fmt::format("\n{:<20}", title);
  for (Eigen::Index c = 0; c < counts.cols(); ++c) {
    const int column = static_cast<int>(c);
    text += fmt::format("{:>10}", by_interface ? interface_name(study, column)
                                               : fmt::format("block {}", column + 1));
  }
  text += "\n";
  for (Eigen::Index r = 0; r < counts.rows(); ++r) {
    text += fmt::format("  {:<18}", interface_name(study, static_cast<int>(r)));
    for (Eigen::Index c = 0; c < counts.cols(); ++c) text += fmt::format("{:>10}", counts(r, c));
    text += "\n";
  }
  return text;
}

void print_plain(const Study& study, const std::vector<Plan>& plans,
                 const study::Balance& balance) {
  for (const Plan& plan : plans) print_text(trials_text(study, plan));
  print_text(counts_text(study, balance.position, "came in", false));
  print_text(counts_text(study, balance.carry_over, "came right before", true));
  if (!balance.even) {
    print_text("\nThe orders are not balanced for this number of participants.\n");
  }
}

void run(const Options& options) {
  const study::StudyBundle bundle = study::load_study(options.file, interfaces());
  print_problems(bundle.warnings);
  std::vector<Plan> plans;
  plans.reserve(static_cast<std::size_t>(options.participants));
  for (int i = 0; i < options.participants; ++i) {
    plans.push_back(study::make_plan(bundle.study, i));
  }
  const study::Balance balance = study::balance_of(bundle.study, plans);
  if (!options.json) return print_plain(bundle.study, plans, balance);
  Json json = {{"study", bundle.study.name},
               {"sha256", bundle.sha256},
               {"participants", options.participants}};
  json["sequences"] = Json::array();
  for (const Plan& plan : plans) json["sequences"].push_back(plan_json(bundle.study, plan));
  json["balance"] = balance_json(bundle.study, balance);
  print_json(json);
}

}  // namespace

void add_plan_command(CLI::App& program) {
  auto options = std::make_shared<Options>();
  CLI::App* command = program.add_subcommand("plan", "Who gets what in which order");
  command->add_option("study", options->file, "the study file (.toml or .study)")->required();
  command->add_option("--participants", options->participants, "how many sessions to plan")
      ->required()
      ->check(CLI::Range(1, 100'000));
  command->add_flag("--json", options->json, "one JSON document on stdout");
  command->callback([options] { run(*options); });
}

}  // namespace promenade::app
