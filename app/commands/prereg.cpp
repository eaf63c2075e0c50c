// `promenade prereg`: the document to register before the first session.
#include <cstdio>
#include <filesystem>

#include "app/commands.h"
#include "app/prereg_page.h"
#include "app/print.h"
#include "app/registry.h"
#include "motion/files.h"
#include "study/identity.h"
#include "study/prereg_seal.h"

namespace promenade::app {
namespace {

struct Options {
  std::string study, plan, out;
};

constexpr int timed_people = 5;

PageFormat format_of(const std::string& file) {
  const std::string ending = std::filesystem::path(file).extension();
  if (ending != ".html" && ending != ".md") {
    throw InputError("--out " + file, "must end in .md or .html");
  }
  return ending == ".html" ? PageFormat::html : PageFormat::markdown;
}

study::SessionLength length_of(const study::StudyBundle& bundle) {
  int done = 0;
  const auto length = study::session_length(bundle, interfaces(), timed_people, [&] {
    show_progress("sessions timed:", ++done, timed_people);
    return !interrupted();
  });
  show_progress("sessions timed:", timed_people, timed_people);
  if (interrupted()) throw OutsideError("stopped before it was done; nothing was written");
  return length;
}

// What to do next, as the document by itself seals nothing.
void tell_how_to_seal(const Options& options, const study::StudyBundle& bundle,
                      const std::string& document) {
  std::fprintf(stderr, "%s: SHA-256 %s\n", options.out.c_str(),
               study::sha256_hex(document).c_str());
  const std::string named =
      std::filesystem::path(options.out)
          .lexically_proximate(std::filesystem::path(bundle.file).parent_path())
          .string();
  std::fprintf(stderr,
               "to seal it, put the line  prereg = \"%s\"  under [study] in %s before the first "
               "session\n",
               named.c_str(), bundle.file.c_str());
}

void run(const Options& options) {
  const PageFormat format = format_of(options.out);
  interrupted();
  const study::StudyBundle bundle = study::load_unsealed_study(options.study, interfaces());
  print_problems(bundle.warnings);
  const std::string text = read_file(options.plan);
  const analysis::AnalysisPlan plan = analysis::read_plan(options.plan, text, &bundle.study);
  const std::string document = prereg_page({bundle, plan, text, length_of(bundle)}, format);
  write_file(options.out, document);
  tell_how_to_seal(options, bundle, document);
}

}  // namespace

void add_prereg_command(Command program) {
  auto options = std::make_shared<Options>();
  Command command =
      program.add_subcommand("prereg", "A document to register before the first session");
  command.add_option("STUDY", options->study, "the study file (.toml or .study)").required();
  command
      .add_option("PLAN", options->plan,
                  "the plan of its analysis (.toml); docs/analysts.md shows one")
      .required();
  command.add_option("--out", options->out, "the document to write (.md or .html)").required();
  command.callback([options] { run(*options); });
}

}  // namespace promenade::app
