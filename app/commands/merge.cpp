// `promenade merge`: joins the databases of stations.
#include "study/merge.h"

#include <fmt/format.h>

#include "app/commands.h"
#include "app/print.h"

namespace promenade::app {
namespace {

struct Options {
  std::string out;
  std::vector<std::string> inputs;
  bool json = false;
};

Json counts_json(const study::RowCounts& counts) {
  Json json = Json::object();
  for (const auto& [table, rows] : counts) json[table] = rows;
  return json;
}

Json json_of(const Options& options, const study::Merged& merged) {
  Json json = {{"db", options.out}, {"sessions", merged.sessions}, {"inputs", Json::array()}};
  for (const study::MergedInput& input : merged.inputs) {
    json["inputs"].push_back({{"file", input.file},
                              {"taken", counts_json(input.taken)},
                              {"known_sessions", input.known},
                              {"withdrawn_sessions", input.withdrawn},
                              {"continued_sessions", input.gone_on}});
  }
  json["removed"] = counts_json(merged.removed);
  json["renamed"] = Json::object();
  for (const auto& [code, fresh] : merged.renamed) json["renamed"][code] = fresh;
  json["warnings"] = Json::array();
  for (const Problem& warning : merged.warnings) json["warnings"].push_back(to_json(warning));
  return json;
}

std::string line_of(const study::MergedInput& input) {
  const auto taken = input.taken.find("session");
  std::string line = fmt::format("{}: {} sessions taken, {} known", input.file,
                                 taken == input.taken.end() ? 0 : taken->second, input.known);
  if (input.gone_on > 0) line += fmt::format(", {} have gone on", input.gone_on);
  if (input.withdrawn > 0) line += fmt::format(", {} left out (withdrawn)", input.withdrawn);
  return line + "\n";
}

std::string text_of(const Options& options, const study::Merged& merged) {
  std::string text;
  for (const study::MergedInput& input : merged.inputs) text += line_of(input);
  for (const auto& [code, fresh] : merged.renamed) {
    text += fmt::format("{} is simulated and has the code {} now\n", code, fresh);
  }
  const auto removed = merged.removed.find("participant");
  if (removed != merged.removed.end()) {
    text += fmt::format("{} people were removed: they withdrew elsewhere\n", removed->second);
  }
  return text + fmt::format("{} holds {} sessions\n", options.out, merged.sessions);
}

void report_unreached(const study::Merged& merged) {
  for (const study::ReachedBackup& backup : merged.backups) {
    if (backup.problem.empty()) continue;
    throw OutsideError("merged, but the backup " + backup.path +
                       " may still hold a person who withdrew (" + backup.problem +
                       "); see to it and call `promenade withdraw` without a code");
  }
}

void run(const Options& options) {
  interrupted();  // from now on Ctrl-C is seen between two sessions
  const study::Merged merged = study::merge(options.out, options.inputs, [](int done, int count) {
    show_progress("sessions", done, count);
    return !interrupted();
  });
  print_problems(merged.warnings);
  if (options.json) {
    print_json(json_of(options, merged));
  } else {
    print_text(text_of(options, merged));
  }
  report_unreached(merged);
}

}  // namespace

void add_merge_command(Command program) {
  auto options = std::make_shared<Options>();
  Command command = program.add_subcommand("merge", "Joins the databases of stations");
  command.add_option("OUT", options->out, "the database to make or to add to").required();
  command.add_option("IN", options->inputs, "databases of the same study").required();
  command.add_flag("--json", options->json, "one JSON document on stdout");
  command.callback([options] { run(*options); });
}

}  // namespace promenade::app
