#include <cstdio>
#include <memory>

#include "analysis/vectors.h"
#include "app/commands.h"
#include "motion/files.h"

namespace promenade::app {

void add_stats_command(Command program) {
  Command command =
      program.add_subcommand("stats", "Runs every case of a vectors file through our statistics");
  auto file = std::make_shared<std::string>();
  command.add_option("VECTORS.json", *file, "test vectors: {\"families\": {NAME: [cases]}}")
      .required();
  command.add_flag("--json").description("print JSON, which is what it does anyway");
  command.callback([file] {
    const std::string results = analysis::run_vectors(*file, read_file(*file));
    std::fwrite(results.data(), 1, results.size(), stdout);
  });
}

}  // namespace promenade::app
