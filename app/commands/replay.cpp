// `promenade replay`: a logged session again, through the same code.
#include "study/replay.h"

#include <fmt/format.h>

#include <charconv>
#include <filesystem>
#include <map>

#include "app/commands.h"
#include "app/print.h"
#include "app/registry.h"
#include "app/replay_window.h"
#include "study/migrate.h"
#include "study/sqlite.h"
#include "study/stored_study.h"
#include "study/trial_list.h"

namespace promenade::app {
namespace {

struct Options {
  std::string database, trial, folder, size = "1280x720";
  double speed = 1, fps = 30;
  bool audit = false, list = false, json = false, windowed = false;
};

Json to_json(const study::Difference& difference) {
  return {{"session", difference.session}, {"trial", difference.trial},
          {"t_us", difference.t_us},       {"what", difference.what},
          {"stored", difference.stored},   {"replayed", difference.replayed}};
}

Json to_json(const std::string& file, const study::Audit& audit) {
  Json json = {{"db", file},
               {"ok", audit.differences.empty()},
               {"sessions", audit.sessions},
               {"trials", audit.trials},
               {"events", audit.events},
               {"samples", audit.samples},
               {"numbers", audit.numbers},
               {"largest_relative_difference", audit.largest}};
  json["differences"] = Json::array();
  for (const study::Difference& one : audit.differences)
    json["differences"].push_back(to_json(one));
  return json;
}

// Each session with the version of the study that it ran on.
study::Audit audit_all(study::Database& database) {
  study::Audit result;
  std::map<std::string, study::StudyBundle> studies;
  const std::vector<std::string> uuids = study::session_uuids(database);
  for (std::size_t i = 0; i < uuids.size(); ++i) {
    const study::LoggedSession log = study::read_session(database, uuids[i]);
    auto known = studies.find(log.study_uuid);
    if (known == studies.end()) {
      known = studies
                  .emplace(log.study_uuid,
                           study::read_stored_study(database, log.study_uuid, interfaces()))
                  .first;
    }
    study::audit(known->second, interfaces(), log, result);
    show_progress("sessions audited:", static_cast<int>(i) + 1, static_cast<int>(uuids.size()));
    if (interrupted()) {
      throw OutsideError(fmt::format("stopped after {} of {} sessions", i + 1, uuids.size()));
    }
  }
  return result;
}

std::string difference_line(const study::Difference& one) {
  return fmt::format(
      "  session {}, trial {}, at {} us: {} is stored as {}, the events lead to {}\n", one.session,
      one.trial, one.t_us, one.what, one.stored, one.replayed);
}

void run_audit(const Options& options, study::Database& database) {
  const study::Audit audit = audit_all(database);
  if (options.json) {
    print_json(to_json(options.database, audit));
  } else {
    for (const study::Difference& one : audit.differences) print_text(difference_line(one));
    print_text(
        fmt::format("{} sessions, {} trials, {} events: {} numbers compared, the largest "
                    "relative difference is {:.2g}\n",
                    audit.sessions, audit.trials, audit.events, audit.numbers, audit.largest));
  }
  if (audit.differences.empty()) return;
  throw OutsideError(fmt::format(
      "{}: {} of the stored values are not what the events lead to; the file was changed, or "
      "another version of Promenade wrote it",
      options.database, audit.differences.size()));
}

Json to_json(const study::ListedTrial& trial) {
  const auto named = [](const std::string& name) { return name.empty() ? Json() : Json(name); };
  return {{"uuid", trial.uuid},
          {"session", trial.session},
          {"participant", trial.participant},
          {"simulated", trial.simulated},
          {"pilot", trial.pilot},
          {"position", trial.position},
          {"attempt", trial.attempt},
          {"superseded", trial.superseded},
          {"practice", trial.practice},
          {"task", trial.task},
          {"interface", named(trial.interface)},
          {"target", named(trial.target)},
          {"outcome", named(trial.outcome)},
          {"seconds", app::to_json(trial.seconds)},
          {"d_final", app::to_json(trial.d_final)}};
}

// "-" where there is nothing.
std::string cell(const std::string& text) { return text.empty() ? "-" : text; }
std::string cell(const std::optional<double>& value, int digits) {
  return value ? fmt::format("{:.{}f}", *value, digits) : "-";
}

void run_list(const Options& options, study::Database& database) {
  const std::vector<study::ListedTrial> trials = study::list_trials(database);
  if (options.json) {
    Json json = {{"db", options.database}, {"trials", Json::array()}};
    for (const study::ListedTrial& trial : trials) json["trials"].push_back(to_json(trial));
    return print_json(json);
  }
  constexpr const char* row = "{:<36}  {:<12}{:>4}  {:<14}{:<14}{:<14}{:<9}{:>8}{:>9}\n";
  print_text(fmt::format(fmt::runtime(row), "trial", "participant", "no.", "task", "interface",
                         "target", "outcome", "seconds", "D, m"));
  for (const study::ListedTrial& trial : trials) {
    print_text(fmt::format(fmt::runtime(row), trial.uuid, trial.participant, trial.position,
                           trial.task, cell(trial.interface), cell(trial.target),
                           cell(trial.outcome), cell(trial.seconds, 2), cell(trial.d_final, 4)));
  }
}

// A trial with all that it takes to play it.
struct Chosen {
  study::ListedTrial listed;
  study::LoggedSession log;
  study::StudyBundle bundle;
  int index = 0;
};

Chosen choose(const Options& options, study::Database& database) {
  const study::ListedTrial listed = study::choose_trial(database, options.trial);
  study::LoggedSession log = study::read_session(database, listed.session);
  study::StudyBundle bundle = study::read_stored_study(database, log.study_uuid, interfaces());
  Chosen chosen{listed, std::move(log), std::move(bundle)};
  const std::vector<study::LoggedTrial>& trials = chosen.log.trials;
  while (trials[static_cast<std::size_t>(chosen.index)].uuid != listed.uuid) ++chosen.index;
  return chosen;
}

struct Size {
  int width = 0, height = 0;
};

// Smaller than the least the page would be cut.
Size size_of(const std::string& text) {
  constexpr Size least{640, 376};
  constexpr int most = 8192;
  const std::size_t cross = text.find('x');
  Size size;
  const auto number = [&text](std::size_t from, std::size_t to, int& value) {
    const auto [end, error] = std::from_chars(text.data() + from, text.data() + to, value);
    return error == std::errc() && end == text.data() + to;
  };
  const bool read = cross != std::string::npos && number(0, cross, size.width) &&
                    number(cross + 1, text.size(), size.height);
  if (read && size.width >= least.width && size.height >= least.height && size.width <= most &&
      size.height <= most) {
    return size;
  }
  throw InputError("--size " + text,
                   fmt::format("must be WIDTHxHEIGHT in pixels, as in 1280x720, at least {}x{} "
                               "and at most {}x{}",
                               least.width, least.height, most, most));
}

void check_folder(const std::string& folder) {
  namespace fs = std::filesystem;
  std::error_code error;
  const fs::file_status status = fs::status(folder, error);
  if (!fs::exists(status)) return;
  if (!fs::is_directory(status)) throw InputError(folder, "is no folder; name a new one");
  if (!fs::is_empty(folder, error) || error) {
    throw InputError(folder, "is not empty; name a new folder for the pictures");
  }
}

void print_pictures(const Options& options, const Chosen& chosen, const Size& size, int count) {
  if (!options.json) {
    return print_text(fmt::format("{} pictures of trial {} are in {}\n", count, chosen.listed.uuid,
                                  options.folder));
  }
  print_json({{"db", options.database},
              {"trial", to_json(chosen.listed)},
              {"folder", options.folder},
              {"files", "frame-%05d.png"},
              {"pictures", count},
              {"fps", options.fps},
              {"speed", options.speed},
              {"width", size.width},
              {"height", size.height}});
}

void run_pictures(const Options& options, study::Database& database) {
  const Size size = size_of(options.size);
  check_folder(options.folder);
  const Chosen chosen = choose(options, database);
  int wanted = 0;
  const int count = write_pictures({chosen.bundle, chosen.log, chosen.index, options.speed},
                                   {.folder = options.folder,
                                    .fps = options.fps,
                                    .width = size.width,
                                    .height = size.height,
                                    .progress = [&wanted](int done, int all) {
                                      show_progress("pictures:", done, wanted = all);
                                      return !interrupted();
                                    }});
  if (count < wanted) {
    throw OutsideError(fmt::format("stopped after {} of {} pictures; those in {} are whole", count,
                                   wanted, options.folder));
  }
  print_pictures(options, chosen, size, count);
}

void run(const Options& options) {
  interrupted();
  study::Database database = study::open_log(options.database);
  database.exec("BEGIN");  // one state of it, whoever writes meanwhile
  if (options.audit) return run_audit(options, database);
  if (options.list) return run_list(options, database);
  if (!options.folder.empty()) return run_pictures(options, database);
  if (options.json) throw InputError("--json", "goes with --audit, --list or --frames");
  const Chosen chosen = choose(options, database);
  play_in_window({chosen.bundle, chosen.log, chosen.index, options.speed}, options.windowed);
}

// What it can be asked for, one at a time.
void add_kinds(Command command, Options& options) {
  Option list = command.add_flag("--list", options.list, "the trials of the database");
  Option audit = command.add_flag("--audit", options.audit,
                                  "recompute every stored weight and D from the events");
  Option frames =
      command.add_option("--frames", options.folder, "writes the trial as pictures to this folder");
  list.excludes(audit).excludes(frames);
  audit.excludes(frames);
  command.add_option("--fps", options.fps, "pictures for a second (30)")
      .range(0.1, 1000.0)
      .needs(frames);
  command.add_option("--size", options.size, "of the pictures, pixels (1280x720)").needs(frames);
}

}  // namespace

void add_replay_command(Command program) {
  auto options = std::make_shared<Options>();
  Command command = program.add_subcommand("replay", "Plays a logged trial again");
  command.add_option("db", options->database, "the database of a study").required();
  command.add_option("--trial", options->trial, "the uuid of a trial; else the last that ended");
  add_kinds(command, *options);
  command.add_option("--speed", options->speed, "1 as in life, 2 twice as fast").range(0.05, 50.0);
  command.add_flag("--windowed", options->windowed, "1280 x 720 instead of the whole screen");
  command.add_flag("--json", options->json, "one JSON document on stdout");
  command.callback([options] { run(*options); });
}

}  // namespace promenade::app
