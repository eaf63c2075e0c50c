// `promenade doctor`: is this machine fit for a study, and why?
#include "app/doctor/doctor.h"

#include <fmt/format.h>
#include <unistd.h>

#include "app/commands.h"

namespace promenade::app {
namespace {

struct Options {
  DoctorOptions doctor;
  bool json = false;
};

std::string_view mark_of(Verdict verdict) {
  return verdict == Verdict::ok ? "ok" : verdict == Verdict::warning ? "WARNING" : "FAILURE";
}

void print_plain(const DoctorReport& report) {
  for (const Check& check : report.checks) {
    print_text(fmt::format("{:<9}{:<9}{}\n", mark_of(check.verdict), check.name, check.says));
  }
  if (report.fit()) print_text("This machine is fit for a study.\n");
}

void run(const Options& options) {
  interrupted();  // from now on Ctrl-C closes the window properly
  if (::isatty(STDERR_FILENO) != 0) {
    std::fputs(
        fmt::format("  measuring, about {:.0f} seconds\n", options.doctor.seconds + 2).c_str(),
        stderr);
  }
  const DoctorReport report = run_doctor(options.doctor);
  if (options.json) {
    print_json(to_json(report));
  } else {
    print_plain(report);
  }
  if (report.fit()) return;
  throw OutsideError("this machine is not fit for a study; do what is said where a check failed");
}

}  // namespace

void add_doctor_command(Command program) {
  auto options = std::make_shared<Options>();
  Command command = program.add_subcommand("doctor", "Is this machine fit for a study, and why?");
  command.add_option("--db", options->doctor.database,
                     "the database of the study, whose disk is tried (default: in results/)");
  command.add_option("--seconds", options->doctor.seconds, "how long frames are timed (default: 4)")
      .range(1.0, 600.0);
  const Option windowed = command.add_flag("--windowed", options->doctor.windowed,
                                           "1280 x 720 instead of the whole screen");
  command.add_option("--screen", options->doctor.screen, "the display that is tried, from 1")
      .range(1, 64)
      .excludes(windowed);
  command.add_flag("--json", options->json, "one JSON document on stdout");
  command.callback([options] { run(*options); });
}

}  // namespace promenade::app
