// The path of the pelvis: it turns, sways and surges by the style; its height is
// what the knee of the bearing leg asks for, freed of everything quicker than a
// body can follow.
#pragma once

#include <array>

#include "motion/gait/feet.h"

namespace promenade::motion::gait {

inline constexpr int height_harmonics = 3;

// Height over the stride, metres: mean, then cosine and sine of each harmonic.
using PelvisHeight = std::array<double, 2 * height_harmonics + 1>;

PelvisHeight pelvis_height(const GaitStyle& style);
double height_at(const PelvisHeight& height, double stride);

Eigen::Quaterniond pelvis_turn(const GaitStyle& style, double stride);

// Horizontal position, metres, at a stride that counts on; height 0.
Eigen::Vector3d pelvis_path(const GaitStyle& style, double stride);

// The hip from the pelvis, metres, in the world.
Eigen::Vector3d hip_offset(const GaitStyle& style, Side side, double stride);

}  // namespace promenade::motion::gait
