// `promenade run`: a participant's session in a window.
#include <fmt/format.h>

#include <algorithm>

#include "app/commands.h"
#include "app/participant_code.h"
#include "app/print.h"
#include "app/registry.h"
#include "app/roster_place.h"
#include "app/session_window.h"
#include "motion/did_you_mean.h"
#include "motion/files.h"

namespace promenade::app {
namespace {

struct Options {
  std::string file, database, participant, station = "1", language, trace, roster;
  int screen = 0;
  bool has_participant = false;
  bool pilot = false, windowed = false;
  std::optional<std::uint64_t> autopilot;
};

// Empty: the first page asks.
std::string choose_language(const Options& options, const study::Study& study) {
  const std::vector<std::string>& offered = study.languages;
  if (options.language.empty()) return offered.size() == 1 ? offered.front() : "";
  if (std::find(offered.begin(), offered.end(), options.language) != offered.end()) {
    return options.language;
  }
  throw InputError(
      "--language " + options.language,
      "this study is offered in " + quoted_list(offered) + did_you_mean(options.language, offered));
}

// Empty: the welcome page asks.
std::string given_code(const Options& options) {
  if (!options.has_participant) return "";
  const std::string problem = participant_code_problem(options.participant);
  if (!problem.empty()) throw InputError("--participant", problem);
  return options.participant;
}

void print_result(const SessionResult& result, const std::string& database) {
  if (result.outcome == study::Outcome::running) {
    print_text(fmt::format("{} goes on another day; the session waits in {}\n", result.participant,
                           database));
  } else {
    print_text(fmt::format("session {}; it is in {}\n", study::to_text(result.outcome), database));
  }
  print_text(
      fmt::format("frames: every {:.1f} ms in the middle, {:.1f} ms at the 99th percentile; "
                  "drawn in {:.1f} and {:.1f} ms\n",
                  result.frame_median, result.frame_p99, result.work_median, result.work_p99));
}

RosterCheck check_of(const Options& options, const SessionSetting& setting,
                     const std::string& code) {
  return {options.roster, code, setting.station, setting.database, setting.autopilot.has_value()};
}

// The participant's row has the code and the order that the session gets; without a code the
// welcome page asks for it.
void take_place(const Options& options, SessionSetting& setting) {
  if (options.roster.empty()) return;
  if (options.pilot) throw InputError("--roster", "is for sessions that count, not for a --pilot");
  study::read_roster(options.roster, read_file(options.roster));  // every problem of it first
  setting.ask_roster = [&options, &setting](const std::string& typed) {
    return ask_roster(check_of(options, setting, typed));
  };
  if (!options.has_participant && !setting.autopilot) return;
  const RosterCheck check = check_of(options, setting, setting.participant);
  const study::RosterRow row = options.has_participant ? roster_place(check) : next_place(check);
  setting.participant = row.code;
  setting.sequence = row.sequence;
}

// That it failed is no reason to lose sight of the session: `roster --done-in` finds it all the
// same.
void leave_place(const Options& options, const SessionSetting& setting,
                 const SessionResult& result) {
  if (options.roster.empty() || !result.recorded) return;
  try {
    store_place(check_of(options, setting, result.participant), result.outcome);
  } catch (const std::exception& error) {
    print_note(std::string("warning: the place in the roster is not stored: ") + error.what());
  }
}

void run(const Options& options) {
  study::StudyBundle bundle = study::load_study(options.file, interfaces());
  if (options.screen > 0) bundle.study.display.screen = options.screen;
  SessionSetting setting{.bundle = bundle,
                         .database = options.database,
                         .participant = given_code(options),
                         .station = options.station,
                         .language = choose_language(options, bundle.study),
                         .pilot = options.pilot,
                         .windowed = options.windowed,
                         .autopilot = options.autopilot,
                         .trace = options.trace};
  if (setting.database.empty()) setting.database = "results/" + bundle.study.name + ".db";
  take_place(options, setting);
  print_problems(bundle.warnings);
  interrupted();  // from now on Ctrl-C ends the session properly
  const SessionResult result = run_session(setting);
  if (result.copy_problem) print_note("warning: " + *result.copy_problem);
  leave_place(options, setting, result);
  if (result.interrupted && !result.recorded) {
    throw OutsideError("interrupted before the session began; nothing is stored, start it again");
  }
  if (result.interrupted) {
    throw OutsideError("interrupted; the session until then is in " + setting.database +
                       ", start a new one for the next participant");
  }
  print_result(result, setting.database);
}

}  // namespace

void add_run_command(Command program) {
  auto options = std::make_shared<Options>();
  Command command = program.add_subcommand("run", "A participant's session in a window");
  command.add_option("study", options->file, "the study file (.toml or .study)").required();
  command.add_option("--db", options->database, "the database (default: results/STUDY.db)");
  const Option code = command.add_option("--participant", options->participant,
                                         "the participant's code; without it the first page asks");
  command.add_flag("--pilot", options->pilot, "a trial run that does not count");
  command.add_option("--station", options->station, "the name of this place");
  command.add_option("--roster", options->roster,
                     "the roster (.csv) that has the participant's code and order");
  command.add_option("--language", options->language, "en or ja; without it the first page asks");
  const Option windowed =
      command.add_flag("--windowed", options->windowed, "1280 x 720 instead of the whole screen");
  command.add_option("--screen", options->screen, "the display, from 1, instead of the study's own")
      .range(1, 64)
      .excludes(windowed);
  command
      .add_option("--autopilot", options->autopilot,
                  "a simulated participant with this seed takes the mouse")
      .range(std::int64_t{0}, std::int64_t{INT64_MAX});
  command.add_option("--trace", options->trace, "what is stored, line by line").group("");
  command.callback([options, code] {
    options->has_participant = code.given();
    run(*options);
  });
}

}  // namespace promenade::app
