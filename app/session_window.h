// A participant's session in a window.
#pragma once

#include <functional>
#include <optional>
#include <string>

#include "app/live_session.h"
#include "app/roster_place.h"
#include "app/window/input_queue.h"

namespace promenade::app {

struct SessionSetting {
  const study::StudyBundle& bundle;
  std::string database;     // file
  std::string participant;  // code; empty: asked for on the welcome page
  std::string station = "1";
  std::string language;  // empty: the first page asks
  bool pilot = false, windowed = false;
  std::optional<std::uint64_t> autopilot = {};  // seed of the simulated participant
  // For measurements: is told of every event of the window as it arrives.
  std::function<void(const UiEvent&)> watch_input = {};
  std::string trace = {};            // Store::trace_to; empty: none
  std::optional<int> sequence = {};  // the order that a roster gives; nothing: the next one
  // What a roster says to a code on the welcome page; empty: there is none.
  std::function<RosterAnswer(const std::string& typed)> ask_roster = {};
};

struct SessionResult {
  study::Outcome outcome = study::Outcome::running;
  bool recorded = false;         // there was a code, and the session is in the database
  std::string participant = {};  // the code
  std::optional<std::string> copy_problem = {};  // why the study's second copy could not be made
  bool interrupted = false;  // by Ctrl-C or another signal, not by the participant
  // Milliseconds; 0 when there were too few frames.
  double frame_median = 0, frame_p99 = 0, work_median = 0, work_p99 = 0;
};

// Returns when the session is over. Throws OutsideError without a display, and
// when the log cannot be written; then everything until that moment is stored.
SessionResult run_session(const SessionSetting& setting);

}  // namespace promenade::app
