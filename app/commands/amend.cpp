// `promenade amend`: a changed study from now on, in the database of its sessions.
#include "study/amend.h"

#include <fmt/format.h>

#include "app/commands.h"
#include "app/print.h"
#include "app/registry.h"

namespace promenade::app {
namespace {

struct Options {
  std::string database, file, reason;
  bool json = false;
};

std::string amended_text(const Options& options, const study::StudyBundle& bundle,
                         const study::Amended& amended) {
  std::string text = fmt::format(
      "{}: from now on \"{}\" is version \"{}\" (before: \"{}\"); its sessions start with {}\n",
      options.database, bundle.study.name, bundle.study.version, amended.previous_version,
      options.file);
  text += amended.same_orders
              ? "the orders are the same: who finished before counts for the balance\n"
              : "the orders are others: their balance begins anew\n";
  if (amended.interrupted > 0) {
    text += fmt::format("interrupted sessions that cannot be resumed any more: {}\n",
                        amended.interrupted);
  }
  return text;
}

// Who reads the results tells versions by it.
void warn_of_version(const study::StudyBundle& bundle, const study::Amended& amended) {
  if (bundle.study.version != amended.previous_version) return;
  print_problems({{bundle.file, 0, 0,
                   "the version is still \"" + bundle.study.version +
                       "\", as before; give each change a \"version\" of its own",
                   Severity::warning}});
}

void run(const Options& options) {
  const study::StudyBundle bundle = study::load_study(options.file, interfaces());
  print_problems(bundle.warnings);
  const study::Amended amended =
      study::amend_study(options.database, bundle, interfaces(), options.reason);
  warn_of_version(bundle, amended);
  if (!options.json) return print_text(amended_text(options, bundle, amended));
  print_json({{"db", options.database},
              {"study", bundle.study.name},
              {"version", bundle.study.version},
              {"previous_version", amended.previous_version},
              {"sha256", bundle.sha256},
              {"same_orders", amended.same_orders},
              {"interrupted", amended.interrupted}});
}

}  // namespace

void add_amend_command(Command program) {
  auto options = std::make_shared<Options>();
  Command command = program.add_subcommand("amend", "A changed study from now on, with a reason");
  command.add_option("DB", options->database, "the database of its sessions").required();
  command.add_option("study", options->file, "the changed study file (.toml or .study)").required();
  command.add_option("--reason", options->reason, "why it is changed; stands in every report")
      .required();
  command.add_flag("--json", options->json, "one JSON document on stdout");
  command.callback([options] { run(*options); });
}

}  // namespace promenade::app
