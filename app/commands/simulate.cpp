// `promenade simulate`: simulated participants through the same session code.
#include "study/simulate.h"

#include <fmt/format.h>

#include <filesystem>
#include <thread>

#include "app/commands.h"
#include "app/print.h"
#include "app/registry.h"
#include "study/copy.h"
#include "study/identity.h"

namespace promenade::app {
namespace {

struct Options {
  std::string file, database, trace;
  int participants = 0;
  std::uint64_t seed = 0;
  int jobs = 0;
  double straight_lining = 0, leaving = 0;  // shares of people, of pages
  bool copy = false;
  bool json = false;
};

int add_cohort(const Options& options, const study::StudyBundle& bundle) {
  study::Store store(options.database, bundle);
  if (!options.trace.empty()) store.trace_to(options.trace);
  const int resumed = study::resume_simulated_sessions(bundle, interfaces(), store, options.seed);
  if (resumed > 0) print_note(fmt::format("went on with {} interrupted sessions", resumed));
  study::Cohort cohort;
  cohort.participants = options.participants;
  cohort.seed = options.seed;
  cohort.jobs = options.jobs > 0
                    ? options.jobs
                    : static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
  cohort.tendencies.straight_lining = options.straight_lining;
  cohort.tendencies.leaving = options.leaving;
  cohort.machine = Json{{"program", "promenade " + std::string(study::program_version())}}.dump();
  cohort.progress = [&](int done) {
    show_progress("simulated", done, options.participants);
    return !interrupted();
  };
  interrupted();
  return study::simulate_cohort(bundle, interfaces(), store, cohort);
}

// A database of its own that it could not fill is taken away again.
int run_cohort(const Options& options, const study::StudyBundle& bundle) {
  std::error_code ignored;
  const bool there = std::filesystem::exists(options.database, ignored);
  try {
    return add_cohort(options, bundle);
  } catch (const OutsideError&) {
    if (!there) study::remove_unused_store(options.database);
    throw;
  }
}

void renew_copy(const Options& options, const study::StudyBundle& bundle) {
  if (!options.copy) return;
  const auto problem =
      study::second_copy_problem(bundle, options.database, study::SessionHeader().station);
  if (problem) throw OutsideError(*problem);
}

void run(const Options& options) {
  const study::StudyBundle bundle = study::load_study(options.file, interfaces());
  print_problems(bundle.warnings);
  const int stored = run_cohort(options, bundle);
  if (stored < options.participants) {
    throw OutsideError(fmt::format("stopped after {} of {} participants; those are whole in {}",
                                   stored, options.participants, options.database));
  }
  renew_copy(options, bundle);
  if (options.json) {
    print_json({{"db", options.database}, {"participants", stored}, {"seed", options.seed}});
  } else {
    print_text(fmt::format("{} simulated participants are in {}\n", stored, options.database));
  }
}

}  // namespace

void add_simulate_command(Command program) {
  auto options = std::make_shared<Options>();
  Command command = program.add_subcommand("simulate", "Simulated participants, without a window");
  command.add_option("study", options->file, "the study file (.toml or .study)").required();
  command.add_option("--participants", options->participants, "how many")
      .required()
      .range(1, 1'000'000);
  command.add_option("--seed", options->seed, "of everything random in them")
      .required()
      .range(std::int64_t{0}, std::int64_t{INT64_MAX});
  command.add_option("--db", options->database, "the database to make or to add to").required();
  command.add_option("--jobs", options->jobs, "threads; the content does not depend on them")
      .range(1, 256);
  command
      .add_option("--straight-lining", options->straight_lining,
                  "the share of them who answer alike and fast what they rate (0)")
      .range(0.0, 1.0);
  command
      .add_option("--leaving", options->leaving,
                  "the share of pages on which they go on another day, where they can (0)")
      .range(0.0, 1.0);
  command.add_flag("--copy", options->copy,
                   "make the second copy that the study asks for ([safety] copy_to), too");
  command.add_flag("--json", options->json, "one JSON document on stdout");
  command.add_option("--trace", options->trace, "what is stored, line by line").group("");
  command.callback([options] { run(*options); });
}

}  // namespace promenade::app
