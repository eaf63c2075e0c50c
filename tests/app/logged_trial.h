// A session that was played and read back, without a database: what replays are made of.
#pragma once

#include "study/replay.h"
#include "study/study.h"

namespace promenade::app::bench {

struct LoggedTrial {
  study::StudyBundle bundle;
  study::LoggedSession log;  // ends in its only trial, which has an outcome
};

// One trial of the interface with `more` in its [[task]]: about `seconds` of what people do
// (controls, presses, undo, camera, playback, a pause), seen in a frame every 17 ms, each at a whole
// millisecond but for the end. The window was of 1280 x 720.
LoggedTrial played_trial(const std::string& interface, double seconds = 6,
                         const std::string& more = "");

// The rows of a log, as session_log.h reads them.
study::LoggedSession logged(const std::vector<study::Record>& records);

}  // namespace promenade::app::bench
