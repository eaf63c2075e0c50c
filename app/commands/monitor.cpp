// `promenade monitor`: who is where in the sessions that run, read-only.
#include <fmt/format.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <thread>

#include "app/commands.h"
#include "app/desk/words.h"
#include "app/monitor_window.h"
#include "app/monitor_words.h"
#include "app/print.h"
#include "app/registry.h"
#include "study/identity.h"
#include "study/migrate.h"
#include "study/utf8.h"
#include "study/watch.h"

namespace promenade::app {
namespace {

struct Options {
  std::string database;
  bool once = false, json = false, text = false;
  int screen = 0;
};

constexpr std::size_t most_points = 200;  // of D over time, in JSON

Json text_or_null(const std::string& text) { return text.empty() ? Json() : Json(text); }

// D over time, thinned: of each stretch the last.
Json d_over_time(const std::vector<study::WatchedTrial::Shown>& shown) {
  Json points = Json::array();
  const std::size_t step = shown.size() / most_points + 1;
  for (std::size_t i = 0; i < shown.size(); ++i) {
    if ((shown.size() - 1 - i) % step != 0) continue;
    points.push_back({shown[i].seconds, shown[i].d});
  }
  return points;
}

Json to_json(const study::WatchedTrial& trial) {
  const bool measured = !trial.shown.empty();
  return {{"position", trial.position},
          {"attempt", trial.attempt},
          {"practice", trial.practice},
          {"task", trial.task},
          {"interface", text_or_null(trial.interface)},
          {"target", text_or_null(trial.target)},
          {"seconds", trial.seconds},
          {"limit_s", app::to_json(trial.limit_s)},
          {"left_s", app::to_json(trial.left_s())},
          {"threshold_m", app::to_json(trial.threshold_m)},
          {"d", measured ? Json(trial.shown.back().d) : Json()},
          {"d_best", app::to_json(trial.d_best)},
          {"late_frames", trial.late_frames},
          {"d_over_time", d_over_time(trial.shown)}};
}

// Nothing is chosen here: English, as all commands print.
const study::Texts& texts() {
  static const study::Texts english = desk_texts("en");
  return english;
}

std::string doing_of(const study::WatchedSession& session) {
  return doing_words(texts(), session) + advice_words(texts(), session);
}

Json to_json(const study::WatchedSession& session) {
  Json notes = Json::array();
  for (const study::WatchedNote& note : session.notes) {
    notes.push_back({{"t_us", note.t_us}, {"text", note.text}});
  }
  const bool counted = session.frames > 0;
  return {{"uuid", session.uuid},
          {"participant", session.participant},
          {"kind", kind_words(texts(), session)},
          {"station", session.station},
          {"language", session.language},
          {"state", study::to_text(session.state)},
          {"outcome", session.outcome},
          {"doing", doing_of(session)},
          {"page", text_or_null(session.page)},
          {"trial", session.trial ? to_json(*session.trial) : Json()},
          {"trials_done", session.trials_done},
          {"trials", session.trials > 0 ? Json(session.trials) : Json()},
          {"minutes", session.minutes},
          {"minutes_left", app::to_json(session.minutes_left)},
          {"seconds_since_event", session.still_s},
          {"seconds_since_sign_of_life", session.silent_s},
          {"late_frames", counted ? Json(session.late_frames) : Json()},
          {"frames", counted ? Json(session.frames) : Json()},
          {"started_utc", session.started_utc},
          {"ended_utc", text_or_null(session.ended_utc)},
          {"notes", notes}};
}

Json to_json(const std::string& database, const study::Watched& now, const std::string& now_utc) {
  Json json = {{"db", database},
               {"now_utc", now_utc},
               {"study", now.study},
               {"version", now.version},
               {"planned", now.planned > 0 ? Json(now.planned) : Json()},
               {"finished", now.finished},
               {"finished_pilot", now.finished_pilot},
               {"finished_simulated", now.finished_simulated},
               {"sessions", Json::array()}};
  for (const study::WatchedSession& one : now.sessions) json["sessions"].push_back(to_json(one));
  return json;
}

// Filled up, or cut, to so many characters.
std::string cell(const std::string& text, int width) {
  std::string cut(study::first_characters(text, width));
  const int missing = width - study::count_characters(cut);
  return cut + std::string(static_cast<std::size_t>(std::max(0, missing)), ' ') + "  ";
}

std::string d_words(const study::WatchedSession& session) {
  if (!session.trial || session.trial->shown.empty()) return "-";
  return fmt::format("{:.4f}", session.trial->shown.back().d);
}

std::string left_words(const study::WatchedSession& session) {
  const auto left = session.trial ? session.trial->left_s() : std::nullopt;
  return left ? fmt::format("{:.0f} s", *left) : "-";
}

std::string table_of(const study::Watched& now) {
  std::string table = fmt::format("{}: {}\n", now.study, finished_words(texts(), now));
  if (now.sessions.empty()) return table + "no session runs, and none ended in the last 12 hours\n";
  table += cell("participant", 14) + cell("kind", 9) + cell("station", 8) + cell("D, m", 7) +
           cell("left", 6) + "what they do\n";
  for (const study::WatchedSession& one : now.sessions) {
    const bool ended = one.state == study::WatchedState::ended;
    std::string doing = doing_of(one);
    if (one.trial) doing += " (" + trial_words(texts(), one) + ")";
    doing += ended ? ", " + duration_words(texts(), one.ended_s) + " ago"
                   : "; " + life_words(texts(), one);
    table += cell(one.participant, 14) + cell(kind_words(texts(), one), 9) + cell(one.station, 8) +
             cell(d_words(one), 7) + cell(left_words(one), 6) + doing + "\n";
  }
  return table;
}

void print_once(const Options& options) {
  study::open_log(options.database);  // says what is wrong with it
  study::Watch watch(options.database, interfaces());
  const std::string now_utc = study::utc_now();
  const study::Watched& now = watch.look(now_utc);
  if (!now.problem.empty()) throw OutsideError(now.problem);
  if (options.json) return print_json(to_json(options.database, now, now_utc));
  print_text(table_of(now));
}

// Over itself on a terminal, else one table below the other.
void print_again_and_again(const Options& options) {
  constexpr const char* clear = "\x1b[H\x1b[2J";
  study::Watch watch(options.database, interfaces());
  const bool terminal = ::isatty(STDOUT_FILENO) != 0;
  while (!interrupted()) {
    const study::Watched& now = watch.look(study::utc_now());
    std::string text = terminal ? clear : "";
    if (!now.problem.empty()) text += now.problem + "\n";
    if (now.problem.empty() || !now.sessions.empty()) text += table_of(now);
    print_text(text + (terminal ? "\nCtrl-C ends this; the sessions go on.\n" : "\n"));
    if (std::fflush(stdout) != 0) return;  // nobody reads any more
    for (int i = 0; i < 10 && !interrupted(); ++i) {
      std::this_thread::sleep_for(std::chrono::milliseconds(100));
    }
  }
}

void run(const Options& options) {
  if (options.json && !options.once) throw InputError("--json", "goes with --once");
  interrupted();
  if (options.once) return print_once(options);
  // Whoever plays on this machine comes first.
  ::setpriority(PRIO_PROCESS, 0, 10);
  if (options.text) return print_again_and_again(options);
  watch_in_window(options.database, options.screen);
}

}  // namespace

void add_monitor_command(Command program) {
  auto options = std::make_shared<Options>();
  Command command =
      program.add_subcommand("monitor", "Shows the sessions that run, live and read-only");
  command.add_option("db", options->database, "the database of a study; it may not be there yet")
      .required();
  Option once = command.add_flag("--once", options->once, "tells how it is now, and ends");
  command.add_flag("--json", options->json, "with --once: one JSON document on stdout");
  Option text =
      command.add_flag("--text", options->text,
                       "a table in the terminal, renewed every second, instead of a window");
  Option screen = command
                      .add_option("--screen", options->screen,
                                  "fills this display, from 1, instead of a window")
                      .range(1, 64);
  once.excludes(text).excludes(screen);
  text.excludes(screen);
  command.callback([options] { run(*options); });
}

}  // namespace promenade::app
