// What a watcher says of a session, in words for people.
#pragma once

#include <string>

#include "study/watch.h"

namespace promenade::app {

// "42 s", "7 min", "3 h", "2 days".
std::string duration_words(double seconds);

// "real", "pilot" or "simulated".
std::string kind_words(const study::WatchedSession& session);

// What the person does: "trial 7 of 24, practice", "reads the instructions", "interrupted 40 s ago:
// start the program again to resume", "finished".
std::string doing_words(const study::WatchedSession& session);

// "copy with map, to proud"; empty outside trials.
std::string trial_words(const study::WatchedSession& session);

// "22 min played, about 14 min left".
std::string time_words(const study::WatchedSession& session);

// "last event 2 s ago", or how long there was no sign of life.
std::string life_words(const study::WatchedSession& session);

// No sign of life for longer than a program that works is ever silent.
bool is_silent(const study::WatchedSession& session);

// "3 late of 41200 frames"; empty: no frames were counted.
std::string frames_words(const study::WatchedSession& session);

// "12 of 24 participants have finished", with pilots and simulated ones where there are any.
std::string finished_words(const study::Watched& now);

// "12:05": of the session's own time.
std::string clock_words(std::int64_t t_us);

}  // namespace promenade::app
