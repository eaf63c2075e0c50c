// What OpenGL has drawn, as a picture in memory and in a file.
#pragma once

#include <filesystem>
#include <vector>

namespace promenade::app {

struct Photograph {
  int width = 0, height = 0;          // pixels
  std::vector<unsigned char> pixels;  // RGB, the lowest row first
};

// What was drawn to the window, or to an OffScreen while there is one; needs its context.
Photograph photograph(int width, int height);

// The whole file or none of it. Throws OutsideError.
void write_png(const std::filesystem::path& file, const Photograph& photograph);

}  // namespace promenade::app
