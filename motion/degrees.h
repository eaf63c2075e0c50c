// Sines and cosines of angles in degrees, as captures store them.
#pragma once

namespace promenade::motion {

struct SineCosine {
  double sine = 0, cosine = 1;
};

// Within 2.3e-16 of the truth for any finite angle (counted turns too), and exact at
// multiples of 90.
SineCosine sine_cosine_of_degrees(double degrees);

// The same of many angles, to the same bits: several times as fast as std::sin and
// std::cos, since a capture asks millions of times.
void sines_cosines_of_degrees(const double* degrees, int count, double* sines, double* cosines);

}  // namespace promenade::motion
