// The centre of mass of the body from de Leva 1996, male (docs/methods.md, 9).
#pragma once

#include <span>

#include "motion/body.h"
#include "motion/skeleton.h"

namespace promenade::motion {

// A segment runs from one point to another; its mass is concentrated at `centre`, a
// share of the way.
struct Segment {
  enum Point { mid_shoulder = body_joint_count, mid_hip, head_top };  // beside the joints
  int proximal = pelvis, distal = pelvis;                             // BodyJoint or Point
  double mass = 0;                                                    // share of the body
  double centre = 0;                                                  // 0 proximal, 1 distal
};

// 14 segments; masses sum to 1. The hands lie at .79 of a hand that captures do not
// have, so their mass is at the wrist.
std::span<const Segment> body_segments();

// The 20 joints, then the points of Segment::Point: 3 x 23, metres.
using BodyPoints = Eigen::Matrix<double, 3, body_joint_count + 3>;

// The top of the head is the end site of the head joint; without one the head joint.
BodyPoints body_points(const Skeleton& skeleton, const BodyMap& body, const WorldPose& world);

Eigen::Vector3d centre_of_mass(const BodyPoints& points);

}  // namespace promenade::motion
