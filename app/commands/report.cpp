#include "analysis/report/report.h"

#include <cstdio>
#include <memory>

#include "app/commands.h"
#include "app/print.h"
#include "app/registry.h"
#include "motion/problem.h"

namespace promenade::app {
namespace {

struct Arguments {
  analysis::ReportOptions options;
  std::string folder;
};

void run_report(Arguments& arguments) {
  arguments.options.folder = arguments.folder;
  arguments.options.registry = &interfaces();
  arguments.options.progress = [](const std::string& what, int done, int count) {
    show_progress(what, done, count);
    return !interrupted();
  };
  interrupted();
  for (const std::string& note : analysis::write_report(arguments.options)) {
    std::fprintf(stderr, "%s\n", note.c_str());
  }
  std::fprintf(stderr, "%s/report.html\n", arguments.folder.c_str());
}

}  // namespace

void add_report_command(Command program) {
  Command command = program.add_subcommand(
      "report", "From the databases of a study to a report: page, figures, tables, R script");
  auto arguments = std::make_shared<Arguments>();
  analysis::SelectionOptions& selection = arguments->options.selection;
  command
      .add_option("DB", arguments->options.databases,
                  "databases of one study, one for each station")
      .required();
  command.add_option("--out", arguments->folder, "folder of the report; a report in it is replaced")
      .required();
  command.add_flag("--include-simulated", selection.include_simulated)
      .description("count simulated participants, too");
  command.add_flag("--include-pilot", selection.include_pilot)
      .description("count pilot sessions, too");
  command.add_option(
      "--exclude", selection.exclude_file,
      "CSV of people to leave out, with the heading code,reason,rule,date; the last two may "
      "be missing");
  command.add_option("--rated", selection.rated_by,
                     "databases of people who rated what was made (`model outcomes`)");
  command.add_option(
      "--prereg", arguments->options.prereg_file,
      "the document that `promenade prereg` wrote, for a list of what was done otherwise");
  command.callback([arguments] { run_report(*arguments); });
}

}  // namespace promenade::app
