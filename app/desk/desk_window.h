// The window of the desk.
#pragma once

#include <string>

namespace promenade::app {

struct DeskWindowSetting {
  std::string studies;          // the folder of them; empty: see default_studies_folder
  std::string language = "en";  // or "ja"
  // Where what can be touched is written, a line for each: how a test finds it with a real mouse.
  std::string trace;
};

// Returns when the window is closed. Throws OutsideError without a display.
void open_desk(const DeskWindowSetting& setting);

// $PROMENADE_STUDIES, else "Promenade" in the person's home folder.
std::string default_studies_folder();

// What the person's system speaks, if the desk does, else "en".
std::string language_of_system();

}  // namespace promenade::app
