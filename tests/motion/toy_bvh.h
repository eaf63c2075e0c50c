// A small BVH file as text, to be broken in tests.
#pragma once

#include <string>

namespace promenade::motion {

inline const std::string toy_hierarchy =
    "HIERARCHY\n"                                             // 1
    "ROOT Hips\n"                                             // 2
    "{\n"                                                     // 3
    "  OFFSET 0 90 0\n"                                       // 4
    "  CHANNELS 4 Xposition Zrotation Xrotation Yrotation\n"  // 5
    "  JOINT Leg\n"                                           // 6
    "  {\n"                                                   // 7
    "    OFFSET 0 -40 0\n"                                    // 8
    "    CHANNELS 2 Xrotation Yposition\n"                    // 9
    "    End Site\n"                                          // 10
    "    {\n"                                                 // 11
    "      OFFSET 0 -40 0\n"                                  // 12
    "    }\n"                                                 // 13
    "  }\n"                                                   // 14
    "}\n";                                                    // 15
inline const std::string toy_motion =
    "MOTION\n"            // 16
    "Frames: 2\n"         // 17
    "Frame Time: 0.05\n"  // 18
    "5 90 0 0 0 -40\n"    // 19
    "6 0 0 90 90 -50\n";  // 20
inline const std::string toy_bvh = toy_hierarchy + toy_motion;

// The text with the first `from` replaced by `to`.
inline std::string replaced(std::string text, const std::string& from, const std::string& to) {
  return text.replace(text.find(from), from.size(), to);
}

}  // namespace promenade::motion
