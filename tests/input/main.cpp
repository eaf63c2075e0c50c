// Works the real window with mouse and keyboard events of which the true times are known,
// in the middle of a trial, and says how well they were stamped: tools/measure-input runs
// it. Exit code 1: an event was lost, or the order was not kept.
//
//     measure_input EVENTS [PER_SECOND]
#include <fmt/format.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "app/print.h"
#include "app/registry.h"
#include "app/session_window.h"
#include "app/window/frame_loop.h"
#include "study/load_study.h"
#include "study/sqlite.h"
#include "tests/input/injector.h"

namespace promenade::app::input {
namespace {

// The main buttons of the pages before the trial: welcome, consent, instructions.
constexpr Place start{860, 664}, agree{860, 664}, begin{1164, 672};
constexpr const char* study_text = R"toml([study]
name = "input"
set = "builtin:A"
languages = ["en"]

[[interface]]
name = "weights"

[[task]]
name = "match"
kind = "match"
limit_s = 86400
targets = [{ example = "proud" }]
)toml";

// What the run left behind.
struct Findings {
  Matching matching = {};
  SessionResult session = {};
  std::int64_t presses_sent = 0, presses_stored = 0;
  std::string load = {};  // of the machine
};

std::string load_now() {
  std::ifstream file("/proc/loadavg");
  std::string one;
  file >> one;
  return one;
}

std::int64_t stored_presses(const std::string& file) {
  study::Database database(file, study::Database::Mode::read_only);
  study::Statement count(database,
                         "SELECT count(*) FROM event WHERE kind = 'press' AND trial IS NOT NULL");
  return count.step() ? count.integer(0) : 0;
}

std::int64_t presses_of(std::span<const Injected> events) {
  return std::count_if(events.begin(), events.end(), [](const Injected& event) {
    return event.kind == Injected::Kind::button && event.down;
  });
}

// Our own keys and pointer from before the script are none of its events.
bool from_script(const UiEvent& event, std::int64_t began_us) {
  const bool kind = event.kind == UiEvent::Kind::move || event.kind == UiEvent::Kind::button ||
                    event.kind == UiEvent::Kind::key;
  return kind && event.t_us >= began_us;
}

Findings run(const Script& script, const std::filesystem::path& folder) {
  const std::span<Injected> events = shared_events(script.events);
  const pid_t injector = start_injector(script, events);
  const study::StudyBundle bundle =
      study::read_study("input.toml", study_text, interfaces(), study::load_motion_set);
  std::vector<UiEvent> arrived;
  arrived.reserve(static_cast<std::size_t>(script.events) + 1000);
  SessionSetting setting{.bundle = bundle,
                         .database = folder / "input.db",
                         .participant = "P1",
                         .language = "en",
                         .windowed = true};
  setting.watch_input = [&](const UiEvent& event) { arrived.push_back(event); };
  interrupted();  // the injector ends the session by SIGTERM
  Findings findings{.session = run_session(setting), .load = load_now()};
  if (!injector_finished(injector)) throw OutsideError("the events could not be injected");
  const std::int64_t began_us = events.front().t_us;
  std::erase_if(arrived, [&](const UiEvent& event) { return !from_script(event, began_us); });
  findings.matching = match({events.begin(), events.end()}, arrived);
  findings.presses_sent = presses_of(events);
  findings.presses_stored = stored_presses(setting.database);
  return findings;
}

double share(std::int64_t part, std::size_t whole) {
  return whole == 0 ? 0 : 100 * static_cast<double>(part) / static_cast<double>(whole);
}

std::string quantiles(const std::vector<std::int64_t>& times_us) {
  return fmt::format("median {:.2f} ms, 99 % {:.2f} ms, 99.9 % {:.2f} ms, most {:.2f} ms",
                     quantile_ms(times_us, 0.5), quantile_ms(times_us, 0.99),
                     quantile_ms(times_us, 0.999), quantile_ms(times_us, 1));
}

void print(const Findings& findings, const Script& script) {
  const Matching& all = findings.matching;
  const SessionResult& frames = findings.session;
  print_text(fmt::format(
      "injected {} events, {:.0f} a second; arrived {}\n"
      "lost {} ({} moves, {} of the button, {} of keys), foreign or out of order {}\n"
      "presses sent {}, in the database {}\n"
      "error of the stamps: {}\n"
      "their uncertainty: {}\n"
      "the true time is within [t - uncertainty, t]: {:.2f} %; with 0.2 ms more: {:.2f} %\n"
      "frames: every {:.1f} ms in the middle, {:.1f} ms at the 99th percentile; drawn in {:.1f} "
      "and {:.1f} ms\n"
      "load of the machine: {}\n",
      script.events, script.per_second, all.error_us.size(), all.lost(), all.lost_of_kind[0],
      all.lost_of_kind[1], all.lost_of_kind[2], all.foreign, findings.presses_sent,
      findings.presses_stored, quantiles(all.error_us), quantiles(all.uncertainty_us),
      share(all.within(), all.error_us.size()), share(all.within(200), all.error_us.size()),
      frames.frame_median, frames.frame_p99, frames.work_median, frames.work_p99, findings.load));
}

bool complete(const Findings& findings) {
  return findings.matching.lost() == 0 && findings.matching.foreign == 0 &&
         findings.presses_stored == findings.presses_sent;
}

int measure(const Script& script) {
  const std::filesystem::path folder =
      std::filesystem::temp_directory_path() / fmt::format("promenade_input_{}", getpid());
  std::filesystem::create_directories(folder);
  const Findings findings = run(script, folder);
  std::filesystem::remove_all(folder);
  print(findings, script);
  return complete(findings) ? 0 : 1;
}

}  // namespace
}  // namespace promenade::app::input

int main(int count, char** arguments) {
  using namespace promenade::app::input;
  Script script{.clicks_first = {start, agree, begin}};
  if (count > 1) script.events = std::atoi(arguments[1]);
  if (count > 2) script.per_second = std::atof(arguments[2]);
  if (script.events <= 0 || script.events > 150'000 || script.per_second <= 0) {
    std::fputs("usage: measure_input EVENTS [PER_SECOND]; at most 150000 events\n", stderr);
    return 2;
  }
  try {
    return measure(script);
  } catch (const std::exception& error) {
    std::fputs(fmt::format("error: {}\n", error.what()).c_str(), stderr);
    return 1;
  }
}
