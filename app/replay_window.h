// A logged trial on the screen: in a window, or as pictures for a video.
#pragma once

#include <filesystem>
#include <functional>

#include "study/replay.h"

namespace promenade::app {

struct ReplaySetting {
  const study::StudyBundle& bundle;
  const study::LoggedSession& log;
  int trial = 0;     // index into the trials of the log
  double speed = 1;  // as in life
};

// Returns when the window is closed. Throws OutsideError without a display.
void play_in_window(const ReplaySetting& setting, bool windowed);

struct PictureSetting {
  std::filesystem::path folder;
  double fps = 30;                 // pictures for a second of the video
  int width = 1280, height = 720;  // pixels
  // Called after each picture with their number; false: stop here.
  std::function<bool(int done, int count)> progress;
};

// How many pictures there are: one for each step of the video, and one of the end.
int count_pictures(std::int64_t length_us, double fps, double speed);

// Writes frame-00001.png and so on; the same log gives the same pictures on the same machine.
// Returns how many were written. Throws OutsideError without a display, which is asked for
// before anything is written.
int write_pictures(const ReplaySetting& setting, const PictureSetting& pictures);

}  // namespace promenade::app
