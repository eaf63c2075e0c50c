// `promenade pack`: freezes everything that a study shows into one file.
#include "study/pack.h"

#include <fmt/format.h>

#include <filesystem>

#include "app/commands.h"
#include "app/print.h"
#include "app/registry.h"
#include "motion/files.h"

namespace promenade::app {
namespace {

struct Options {
  std::string file, out;
  bool json = false;
};

// Where the study is read from nothing may be written.
void refuse_itself(const Options& options) {
  std::error_code ignored;
  if (!std::filesystem::equivalent(options.file, options.out, ignored)) return;
  throw InputError("--out " + options.out, "is the study itself; name another file");
}

Json pack_json(const Options& options, const study::StudyBundle& bundle, std::size_t bytes) {
  Json parts = Json::array();
  for (const study::StudyPart& part : bundle.parts) parts.push_back(part.path);
  return {
      {"file", options.out},     {"study", bundle.study.name},   {"version", bundle.study.version},
      {"sha256", bundle.sha256}, {"set", bundle.space.set.name}, {"parts", parts},
      {"bytes", bytes}};
}

std::string pack_text(const Options& options, const study::StudyBundle& bundle, std::size_t bytes) {
  std::string text = fmt::format(
      "{}: the study \"{}\", version {}, {} bytes\nhash {}\nholds the study file and the motion "
      "set \"{}\" ({} walks)\n",
      options.out, bundle.study.name, bundle.study.version, bytes, bundle.sha256,
      bundle.space.set.name, bundle.space.set.size());
  for (const study::StudyPart& part : bundle.parts) text += fmt::format("holds {}\n", part.path);
  return text;
}

void run(const Options& options) {
  refuse_itself(options);
  const study::StudyBundle bundle = study::load_study(options.file, interfaces());
  print_problems(bundle.warnings);
  const std::string bytes = study::to_bytes(study::pack_of(bundle));
  write_file(options.out, bytes);
  if (options.json) return print_json(pack_json(options, bundle, bytes.size()));
  print_text(pack_text(options, bundle, bytes.size()));
}

}  // namespace

void add_pack_command(Command program) {
  auto options = std::make_shared<Options>();
  Command command =
      program.add_subcommand("pack", "Freezes a study, with all that it shows, into one file");
  command.add_option("study", options->file, "the study file (.toml or .study)").required();
  command.add_option("--out", options->out, "the packed study (.study)").required();
  command.add_flag("--json", options->json, "one JSON document on stdout");
  command.callback([options] { run(*options); });
}

}  // namespace promenade::app
