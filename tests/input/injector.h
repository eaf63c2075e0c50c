// A process of its own that works mouse and keyboard of the X display through the XTest
// extension, at random times, and notes when it did.
#pragma once

#include <sys/types.h>

#include <span>
#include <string>

#include "tests/input/matching.h"

namespace promenade::app::input {

struct Place {
  int x = 0, y = 0;  // pixels
};

struct Script {
  std::vector<Place> clicks_first;  // the way to the trial
  int events = 0;
  double per_second = 250;  // on average; times between events are exponential
};

// Room for `count` events that two processes share; it is never given back.
std::span<Injected> shared_events(int count);

// Starts the process: it waits for the window, does the script, and then sends SIGTERM to
// this process, which ends a session. Call it before anything opens a display.
pid_t start_injector(const Script& script, std::span<Injected> events);

// Did it do all of its script?
bool injector_finished(pid_t injector);

}  // namespace promenade::app::input
