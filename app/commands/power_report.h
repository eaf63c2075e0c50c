// What `promenade power` says, as text and as JSON.
#pragma once

#include "analysis/power/resampling.h"
#include "app/print.h"
#include "study/simulated.h"

namespace promenade::app {

struct PowerReport {
  std::string study, sha256;
  int round = 1;  // a multiple of it is balanced
  analysis::PowerQuestion question;
  std::vector<analysis::PowerTable> tables;
  // Of a pilot; no files: a rehearsal.
  std::vector<std::string> pilot_files;
  int pilot_people = 0;
  bool pilot_simulated = false;
  analysis::SmallestEffect effect;
  // Of a rehearsal.
  study::Tendencies tendencies;
};

Json power_json(const PowerReport& report);
std::string power_text(const PowerReport& report);

}  // namespace promenade::app
