// What the pictures of a map share; for map_picture*.cpp only.
#pragma once

#include <string>

#include "analysis/pictures/map_picture.h"

namespace promenade::analysis {

// Pixels of the whole picture, and where the map lies in it, from the lower left.
struct Frame {
  double width = 0, height = 0;
  double left = 0, right = 0, bottom = 0, top = 0;
};

// Where in the picture the next plot goes.
std::string place(const Frame& frame);

// Everything up to a plot of the dots, to which more can be added: ", ...".
std::string map_script(const MapPicture& picture, const Frame& frame, bool names);

// Runs the script in the terminal that the ending of the file asks for.
void draw_script(const std::string& script, const Frame& frame, const std::filesystem::path& file);

}  // namespace promenade::analysis
