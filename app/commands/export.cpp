#include "analysis/export/export.h"

#include <cstdio>
#include <memory>

#include "app/commands.h"
#include "app/print.h"
#include "app/registry.h"

namespace promenade::app {
namespace {

struct Arguments {
  analysis::ExportOptions options;
  std::string folder;
};

void run_export(Arguments& arguments) {
  arguments.options.folder = arguments.folder;
  arguments.options.progress = [](const std::string& what, int done, int count) {
    show_progress(what, done, count);
    return !interrupted();
  };
  interrupted();
  for (const std::string& note : analysis::write_export(arguments.options, interfaces())) {
    std::fprintf(stderr, "%s\n", note.c_str());
  }
  std::fprintf(stderr, "%s/README.md\n", arguments.folder.c_str());
}

}  // namespace

void add_export_command(Command program) {
  Command command =
      program.add_subcommand("export", "From a database to CSV with a codebook (Psych-DS)");
  auto arguments = std::make_shared<Arguments>();
  analysis::ExportOptions& options = arguments->options;
  command.add_option("DB", options.database, "the database of a study").required();
  command.add_option("--out", arguments->folder, "folder of the tables").required();
  Option is_public = command.add_flag("--public", options.is_public);
  is_public.description("new codes, relative times, coarse demographics, no free text");
  command.add_option("--reviewed", options.reviewed_file)
      .description("CSV of the free answers that may be published")
      .needs(is_public);
  command.add_flag("--with-motions", options.with_motions)
      .description("also the motions of captures: when their licence allows it")
      .needs(is_public);
  command.add_flag("--include-simulated", options.selection.include_simulated)
      .description("simulated participants are in people_wide.csv, too");
  command.add_flag("--include-pilot", options.selection.include_pilot)
      .description("pilot sessions are in people_wide.csv, too");
  command.callback([arguments] { run_export(*arguments); });
}

}  // namespace promenade::app
