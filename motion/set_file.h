// A motion set as bytes: the file that `set build` writes and the content that
// every database keeps. Little-endian, doubles as they are, with a checksum.
#pragma once

#include <string>
#include <string_view>

#include "motion/motion_set.h"

namespace promenade::motion {

std::string to_bytes(const MotionSet& set);

// Throws InputError with `file` as its place when the bytes are not a whole set.
MotionSet from_bytes(std::string_view bytes, const std::string& file);

}  // namespace promenade::motion
