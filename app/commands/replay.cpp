// `promenade replay`: a logged session again, through the same code.
#include "study/replay.h"

#include <fmt/format.h>

#include <map>

#include "app/commands.h"
#include "app/print.h"
#include "app/registry.h"
#include "study/schema.h"
#include "study/sqlite.h"
#include "study/stored_study.h"

namespace promenade::app {
namespace {

struct Options {
  std::string database, trial;
  bool audit = false, json = false;
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

void run(const Options& options) {
  interrupted();
  study::Database database(options.database, study::Database::Mode::read_only);
  study::check_database(database);
  if (options.audit) return run_audit(options, database);
  throw InputError("replay", "say what to do: --audit");
}

}  // namespace

void add_replay_command(CLI::App& program) {
  auto options = std::make_shared<Options>();
  CLI::App* command = program.add_subcommand("replay", "A logged session again");
  command->add_option("db", options->database, "the database of a study")->required();
  command->add_option("--trial", options->trial, "the uuid of a trial");
  command->add_flag("--audit", options->audit,
                    "recompute every stored weight and D from the events");
  command->add_flag("--json", options->json, "one JSON document on stdout");
  command->callback([options] { run(*options); });
}

}  // namespace promenade::app
