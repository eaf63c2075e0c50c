// Half a turn, and what a degree is of it.
#pragma once

namespace promenade::motion {

inline constexpr double pi = 3.14159265358979323846;
inline constexpr double degree = pi / 180;  // radians

}  // namespace promenade::motion
