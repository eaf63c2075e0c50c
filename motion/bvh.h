// Biovision hierarchy files. The reader takes the dialects that laboratories
// write: channels in any order and number on any joint, several roots, no end
// sites, names with spaces, keywords in any case, any line ends, values in any
// layout. What it cannot take it refuses with the place.
#pragma once

#include <string_view>

#include "motion/clip.h"

namespace promenade::motion {

// Throws InputError with every problem found; warnings are in the clip. Memory is
// bounded by a multiple of the text's size, and nothing recurses on its depth.
Clip read_bvh(std::string_view text, const std::string& file);

// The clip as plain BVH: one line a frame, white space in names replaced by "_".
// Numbers read back to the same double.
std::string bvh_text(const Clip& clip);

}  // namespace promenade::motion
