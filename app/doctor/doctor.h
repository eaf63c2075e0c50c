// Is this machine fit for a study? The long form for `promenade doctor`, and a short one
// that goes before every session and is stored with it.
#pragma once

#include <string>

#include "app/doctor/measure_screen.h"
#include "app/doctor/report.h"

namespace promenade::app {

struct DoctorOptions {
  std::string database = "results/study.db";  // whose folder is tried
  double seconds = 4;                         // that frames are timed for
  bool windowed = false;
  int screen = 0;  // which display, from 1; 0: the first
};

// Opens a window of its own; without a display it checks the rest. Throws OutsideError when
// it is interrupted.
DoctorReport run_doctor(const DoctorOptions& options);

// About one second in a window that is already open.
DoctorReport quick_doctor(const Canvas& canvas, const study::StudyBundle& bundle,
                          const std::string& database);

}  // namespace promenade::app
