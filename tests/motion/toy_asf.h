// A small Acclaim skeleton and motion as text, to be broken in tests.
#pragma once

#include <string>

namespace promenade::motion {

// A bone "up" along +Y; on it "arm" along +X, whose own axes are turned 90 degrees about
// Z, so that its x axis is the world's y; on that the stiff "tip" along +Z.
inline const std::string toy_asf =
    "# a toy\n"                                                          // 1
    ":version 1.10\n"                                                    // 2
    ":name toy\n"                                                        // 3
    ":units\n"                                                           // 4
    "  mass 1.0\n"                                                       // 5
    "  length 0.5\n"                                                     // 6
    "  angle deg\n"                                                      // 7
    ":documentation\n"                                                   // 8
    "  begin anything; limits (1 2)\n"                                   // 9
    ":root\n"                                                            // 10
    "  order TX TY TZ RX RY RZ\n"                                        // 11
    "  axis XYZ\n"                                                       // 12
    "  position 0 0 0\n"                                                 // 13
    "  orientation 0 0 0\n"                                              // 14
    ":bonedata\n"                                                        // 15
    "  begin\n"                                                          // 16
    "    id 1\n"                                                         // 17
    "    name up\n"                                                      // 18
    "    direction 0 1 0\n"                                              // 19
    "    length 3\n"                                                     // 20
    "    axis 0 0 0 XYZ\n"                                               // 21
    "    dof rx ry rz\n"                                                 // 22
    "    limits (-160.0 20.0)\n"                                         // 23
    "           (-70.0 70.0)\n"                                          // 24
    "           (-inf 70.0)  # open\n"                                   // 25
    "  end\n"                                                            // 26
    "  begin\n    name arm\n    direction 1 0 0\n    length 2\n"         // 27-30
    "    axis 0 0 90 XYZ\n"                                              // 31
    "    dof rx\n  end\n"                                                // 32-33
    "  begin\n    name tip\n    direction 0 0 1\n    length 1\n  end\n"  // 34-38
    ":hierarchy\n"                                                       // 39
    "  begin\n"                                                          // 40
    "    root up\n"                                                      // 41
    "    up arm\n"                                                       // 42
    "    arm tip\n"                                                      // 43
    "  end\n";                                                           // 44

inline const std::string toy_amc =
    "#!OML:ASF toy.asf\n"  // 1
    ":FULLY-SPECIFIED\n"   // 2
    ":DEGREES\n"           // 3
    "1\n"                  // 4
    "root 5 6 7 0 0 0\n"   // 5
    "up 0 0 0\n"           // 6
    "arm 90\n"             // 7
    "2\n"                  // 8
    "root 5 6 8 0 90 0\n"  // 9
    "up 10 20 30\n"        // 10
    "arm -45\n";           // 11

}  // namespace promenade::motion
