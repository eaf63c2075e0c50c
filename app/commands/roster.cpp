// `promenade roster`: who is to come, where, and with which order.
#include "study/roster.h"

#include <fmt/format.h>

#include <filesystem>

#include "app/commands.h"
#include "app/print.h"
#include "app/registry.h"
#include "motion/files.h"
#include "study/balance.h"
#include "study/migrate.h"
#include "study/sqlite.h"

namespace promenade::app {
namespace {

using study::Attendance;
using study::RosterRow;
using study::Study;

struct Options {
  std::string study, file, no_show, replace;
  std::vector<std::string> databases;
  int participants = 0, stations = 0;
  bool json = false;
};

std::vector<RosterRow> rows_in(const std::string& file) {
  std::error_code ignored;
  if (!std::filesystem::exists(file, ignored)) return {};
  return study::read_roster(file, read_file(file));
}

// Those who are still expected, or came.
bool takes_part(const RosterRow& row) {
  return row.state == Attendance::booked || row.state == Attendance::done;
}

Json row_json(const RosterRow& row) {
  Json json = {{"code", row.code},
               {"station", row.station},
               {"sequence", row.sequence},
               {"state", study::to_text(row.state)},
               {"replaces", nullptr}};
  if (!row.replaces.empty()) json["replaces"] = row.replaces;
  return json;
}

// What each row gets; nobody's targets need to be drawn for that.
Study without_draws(Study study) {
  for (study::Task& task : study.tasks) {
    for (auto* targets : {&task.targets, &task.practice}) {
      for (study::Target& target : *targets) target.draw = {};
    }
  }
  return study;
}

bool is_even(const Study& study, const std::vector<RosterRow>& rows, const std::string& station) {
  std::vector<study::Plan> plans;
  for (const RosterRow& row : rows) {
    const bool here = station.empty() || row.station == station;
    if (here && takes_part(row)) plans.push_back(study::make_plan(study, row.sequence));
  }
  return study::balance_of(study, plans).even;
}

std::map<std::string, int> people_by_station(const std::vector<RosterRow>& rows) {
  std::map<std::string, int> people;
  for (const RosterRow& row : rows) people[row.station] += takes_part(row) ? 1 : 0;
  return people;
}

void print_roster(const Options& options, const Study& study, const std::vector<RosterRow>& rows) {
  Json json = {{"file", options.file}, {"rows", Json::array()}};
  for (const RosterRow& row : rows) json["rows"].push_back(row_json(row));
  json["even"] = is_even(study, rows, "");
  json["stations"] = Json::array();
  for (const auto& [station, people] : people_by_station(rows)) {
    json["stations"].push_back(
        {{"station", station}, {"people", people}, {"even", is_even(study, rows, station)}});
  }
  if (options.json) return print_json(json);
  print_text(fmt::format("{}: {} codes{}\n", options.file, rows.size(),
                         json["even"] ? "" : "; the orders are not balanced"));
  for (const Json& station : json["stations"]) {
    print_text(fmt::format("  station {}: {} people{}\n", station["station"].get<std::string>(),
                           station["people"].get<int>(),
                           station["even"].get<bool>() ? "" : ", not balanced"));
  }
}

void require_something(const Options& options) {
  const bool deals = options.participants > 0 && options.stations > 0;
  if (deals || !options.no_show.empty() || !options.replace.empty()) return;
  if (!options.databases.empty()) return;
  throw InputError("roster",
                   "needs --participants and --stations, or --no-show CODE, "
                   "--replace CODE, or --done-in DB");
}

void change(const Options& options, const Study& study, std::vector<RosterRow>& rows) {
  if (options.participants == 0 && rows.empty()) {
    throw InputError(options.file,
                     "there is no such roster; make it with --participants and "
                     "--stations");
  }
  if (options.participants > 0) {
    study::extend_roster(options.file, study, options.participants, options.stations, rows);
  }
  for (const std::string& file : options.databases) {
    study::Database database = study::open_log(file);
    study::mark_done(database, rows);
  }
  if (!options.no_show.empty()) study::mark_no_show(options.file, options.no_show, rows);
  if (options.replace.empty()) return;
  const RosterRow& added = study::replace_person(options.file, study, options.replace, rows);
  if (!options.json) print_text(fmt::format("{} comes instead\n", added.code));
}

void run(const Options& options) {
  require_something(options);
  const study::StudyBundle bundle = study::load_study(options.study, interfaces());
  print_problems(bundle.warnings);
  std::vector<RosterRow> rows = rows_in(options.file);
  change(options, bundle.study, rows);
  write_file(options.file, study::roster_csv(rows));
  print_roster(options, without_draws(bundle.study), rows);
}

}  // namespace

void add_roster_command(Command program) {
  auto options = std::make_shared<Options>();
  Command command =
      program.add_subcommand("roster", "Codes and orders for the people of several stations");
  command.add_option("study", options->study, "the study file (.toml)").required();
  command.add_option("--out", options->file, "the roster (.csv) to make, or to change").required();
  Option participants =
      command.add_option("--participants", options->participants, "places that are dealt")
          .range(1, 100'000);
  const Option stations =
      command.add_option("--stations", options->stations, "where people come to")
          .range(1, 100)
          .needs(participants);
  participants.needs(stations);
  command.add_option("--no-show", options->no_show, "the code of somebody who did not come");
  command.add_option("--replace", options->replace,
                     "the code of somebody whose place another person takes");
  command.add_option("--done-in", options->databases,
                     "databases whose finished people are marked as done");
  command.add_flag("--json", options->json, "one JSON document on stdout");
  command.callback([options] { run(*options); });
}

}  // namespace promenade::app
