// How long the frames of a trial take with each interface and 55 styles, on the screen
// that there is: what results/benchmarks.md says of drawing.
#pragma once

#include <filesystem>

namespace promenade::app::screenshots {

// Prints a line for each interface: median and 99th percentile of `frames`, ms.
// Databases go to `folder`.
void print_frame_times(const std::filesystem::path& folder, int frames = 400);

}  // namespace promenade::app::screenshots
