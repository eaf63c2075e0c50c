// `promenade model outcomes`: what people made, as targets for those who rate it.
#include <memory>

#include "analysis/outcomes.h"
#include "app/commands/model_parts.h"
#include "app/print.h"
#include "app/registry.h"
#include "motion/files.h"
#include "study/targets_csv.h"

namespace promenade::app {
namespace {

struct Arguments {
  std::vector<std::string> databases;
  analysis::SelectionOptions selection;
  analysis::OutcomeChoice choice;
  std::string out;
};

void write(const Arguments& given) {
  const analysis::Outcomes made =
      analysis::outcomes_of(given.databases, given.selection, interfaces(), given.choice);
  const std::string table = study::targets_csv(made.targets, made.motions);
  if (given.out.empty()) return print_text(table);
  write_file(given.out, table);
}

}  // namespace

void add_model_outcomes(Command model) {
  Command command = model.add_subcommand(
      "outcomes", "What people made in find tasks, as CSV of targets for a study that rates them");
  const auto given = std::make_shared<Arguments>();
  command.add_option("DB", given->databases, "databases of one study").required();
  command.add_option("--task", given->choice.tasks, "of these tasks, whatever their kind");
  command.add_option("--interface", given->choice.interfaces, "made with these interfaces");
  command.add_flag("--include-simulated", given->selection.include_simulated,
                   "of simulated participants, too");
  command.add_flag("--include-pilot", given->selection.include_pilot, "of pilot sessions, too");
  command.add_option("--exclude", given->selection.exclude_file,
                     "CSV of people to leave out, as `report` reads it");
  command.add_option("--out", given->out, "The file to write; stdout without it");
  command.callback([given] { write(*given); });
}

}  // namespace promenade::app
