// The curves that a gait is made of: smooth steps, waves and cubic pieces.
#pragma once

#include <Eigen/Geometry>
#include <vector>

#include "motion/angles.h"

namespace promenade::motion::gait {

// From 0 to 1 with two vanishing derivatives at both ends; constant outside.
double smooth_step(double x);

// cos(2 pi (phase - peak)), drawn toward its two ends by crispness.
double wave(double phase, double peak, double crispness = 0);

struct Knot {
  double at = 0;
  double value = 0;
  double slope = 0;
};

// Cubic Hermite pieces through ascending knots; constant outside.
double through(const std::vector<Knot>& knots, double x);

// Yaw about Y (to the left), then pitch about X (forward and down), then roll
// about Z (to the right), all in degrees.
Eigen::Quaterniond turned(double yaw, double pitch, double roll);

}  // namespace promenade::motion::gait
