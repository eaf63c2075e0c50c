// What can be measured without a window.
#pragma once

#include <filesystem>

#include "app/doctor/findings.h"
#include "app/look.h"

namespace promenade::app {

// Writes a small database beside `database` (or in the nearest folder above that is there),
// commits it that many times as the end of a trial does, and takes it away again.
DiskFinding measure_disk(const std::filesystem::path& database, int commits);

// Which characters of these texts have no picture in the font.
FontFinding measure_font(const ImFont& font, const std::vector<std::string>& words);
// Those of our fonts, at 1280 x 720. Says in `problem` when they are not installed.
FontFinding measure_fonts(const std::vector<std::string>& words);

ClockFinding measure_clock();

}  // namespace promenade::app
