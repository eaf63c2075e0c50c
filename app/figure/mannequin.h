// The figure that people see: a mannequin of round cones with real volume, made
// to the measure of any skeleton. Start here to understand app/figure.
#pragma once

#include <Eigen/Dense>
#include <array>
#include <vector>

#include "motion/motion_set.h"

namespace promenade::app {

enum class Tone { body, joint };  // joints are darker

// The solid between two spheres; flattened along one direction across its axis.
struct Part {
  Eigen::Vector3f a = Eigen::Vector3f::Zero(), b = Eigen::Vector3f::Zero();  // metres
  float radius_a = 0, radius_b = 0;                                          // metres
  Eigen::Vector3f thin = Eigen::Vector3f::UnitX();                           // unit length
  float flat = 1;  // thickness along `thin`, share of the radius
  Tone tone = Tone::body;
};

// What does not change from pose to pose.
struct Mannequin {
  motion::BodyMap body;
  double scale = 1;                           // of all thicknesses; 1 for a leg of 0.85 m
  double height = 0;                          // of the walking figure, metres
  Eigen::Vector3d head_up, head_ahead;        // in the frame of the head's joint
  std::array<Eigen::Vector3d, 2> foot_ahead;  // in the frames of the ankles, left first
  std::array<Eigen::Vector3d, 2> foot_up;
  std::array<Eigen::Vector3d, 2> toe_ahead, toe_up;  // in the frames of the toes
  double ankle_height = 0, toe_height = 0;           // of a foot that stands flat, metres
};

// How the head and the feet are turned is taken from the motions: on average the
// head, and feet that stand, point where the set walks (ours; skeletons do not say).
Mannequin make_mannequin(const motion::MotionSet& set);

// The same of poses of any motion, at least one: each faces +Z and stands on the floor.
Mannequin make_mannequin(const motion::Skeleton& skeleton, const motion::BodyMap& body,
                         const std::vector<motion::WorldPose>& poses);

// Replaces `parts`. Metres, in the world of the pose.
void place_parts(const Mannequin& mannequin, const motion::WorldPose& pose,
                 std::vector<Part>& parts);

// About the vertical axis through the origin, radians.
void turn(std::vector<Part>& parts, float yaw);

}  // namespace promenade::app
