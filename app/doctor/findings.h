// What the doctor measures on this machine, before anybody judges it. Plain numbers, so
// that tests can make them up.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace promenade::app {

struct DisplayFinding {
  std::string problem = "";                // why no window can be opened; empty: one was
  int width = 0, height = 0;               // of the window, pixels
  double refresh_hz = 0;                   // 0: the display does not say
  double scale = 1;                        // that the desktop asks for
  std::string renderer = "", opengl = "";  // as the driver names them
};

// While two figures walk, as in a trial.
struct PacingFinding {
  double wanted_hz = 60;
  std::vector<std::int64_t> interval_us;  // from one frame on screen to the next
};
struct InputFinding {
  std::vector<std::int64_t> gap_us;  // each stretch in which nobody asked for events
  std::int64_t watched_us = 0;       // the whole time
};

struct DiskFinding {
  std::string folder = "";
  std::string problem = "";                  // why nothing can be written; empty: it can
  std::vector<std::int64_t> commit_us = {};  // of commits that survive a power cut
  std::int64_t free_bytes = 0;
};

struct FontFinding {
  std::string problem = "";               // empty: the files are there
  std::vector<std::string> missing = {};  // characters without a picture
};

struct ClockFinding {
  std::int64_t step_ns = 0;  // the smallest step that was seen
  bool ran_back = false;
  std::string source = "";  // the kernel's name of it; empty: not known
};

struct Findings {
  DisplayFinding display = {};
  std::optional<PacingFinding> pacing = {};  // without a window: nothing
  std::optional<InputFinding> input = {};
  DiskFinding disk = {};
  FontFinding fonts = {};
  ClockFinding clock = {};
};

}  // namespace promenade::app
