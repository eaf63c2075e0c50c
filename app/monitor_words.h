// What a watcher says of a session, in words for people: the texts of configs/desk/watch.*.toml,
// filled in. Whoever has no language of its own takes desk_texts("en").
#pragma once

#include <string>

#include "study/texts.h"
#include "study/watch.h"

namespace promenade::app {

// "42 s", "7 min", "3 h", "2 days".
std::string duration_words(const study::Texts& texts, double seconds);

// "real", "pilot" or "simulated".
std::string kind_words(const study::Texts& texts, const study::WatchedSession& session);

// What the person does: "trial 7 of 24, practice", "reads the instructions", "interrupted 40 s
// ago", "finished".
std::string doing_words(const study::Texts& texts, const study::WatchedSession& session);

// ": start the program again to resume" after it; empty: nothing is interrupted.
std::string advice_words(const study::Texts& texts, const study::WatchedSession& session);

// "copy with map, to proud"; empty outside trials.
std::string trial_words(const study::Texts& texts, const study::WatchedSession& session);

// "22 min played, about 14 left".
std::string time_words(const study::Texts& texts, const study::WatchedSession& session);

// "last event 2 s ago", or how long there was no sign of life.
std::string life_words(const study::Texts& texts, const study::WatchedSession& session);

// No sign of life for longer than a program that works is ever silent.
bool is_silent(const study::WatchedSession& session);

// "3 late of 41200 frames"; empty: no frames were counted.
std::string frames_words(const study::Texts& texts, const study::WatchedSession& session);

// "12 of 24 participants have finished", with pilots and simulated ones where there are any.
std::string finished_words(const study::Texts& texts, const study::Watched& now);

// Why nothing new can be seen; empty: all is well. What SQLite or the disk says stays English.
std::string problem_words(const study::Texts& texts, const study::Watched& now);

// "finished", "stopped", ...
std::string outcome_words(const study::Texts& texts, const study::WatchedSession& session);

// "12:05": of the session's own time.
std::string clock_words(std::int64_t t_us);

}  // namespace promenade::app
