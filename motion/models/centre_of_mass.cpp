#include "motion/models/centre_of_mass.h"

#include <array>

namespace promenade::motion {
namespace {

constexpr std::array<Segment, 14> segments = {{
    {neck, Segment::head_top, .0694, .50},
    {Segment::mid_shoulder, Segment::mid_hip, .4346, .4310},
    {left_shoulder, left_elbow, .0271, .5772},
    {right_shoulder, right_elbow, .0271, .5772},
    {left_elbow, left_wrist, .0162, .4574},
    {right_elbow, right_wrist, .0162, .4574},
    {left_wrist, left_wrist, .0061, 0},
    {right_wrist, right_wrist, .0061, 0},
    {left_hip, left_knee, .1416, .4095},
    {right_hip, right_knee, .1416, .4095},
    {left_knee, left_ankle, .0433, .4395},
    {right_knee, right_ankle, .0433, .4395},
    {left_ankle, left_toe, .0137, .50},
    {right_ankle, right_toe, .0137, .50},
}};

}  // namespace

std::span<const Segment> body_segments() { return segments; }

BodyPoints body_points(const Skeleton& skeleton, const BodyMap& body, const WorldPose& world) {
  BodyPoints points;
  points.leftCols<body_joint_count>() = body_positions(body, world);
  points.col(Segment::mid_shoulder) =
      0.5 * (points.col(left_shoulder) + points.col(right_shoulder));
  points.col(Segment::mid_hip) = 0.5 * (points.col(left_hip) + points.col(right_hip));
  points.col(Segment::head_top) = points.col(head);
  for (const EndSite& site : skeleton.end_sites) {
    if (site.joint != body.joint[head]) continue;
    points.col(Segment::head_top) +=
        world.rotations[static_cast<std::size_t>(site.joint)] * site.offset;
    break;
  }
  return points;
}

Eigen::Vector3d centre_of_mass(const BodyPoints& points) {
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();
  for (const Segment& segment : segments) {
    const Eigen::Vector3d from = points.col(segment.proximal);
    const Eigen::Vector3d to = points.col(segment.distal);
    centre += segment.mass * (from + segment.centre * (to - from));
  }
  return centre;
}

}  // namespace promenade::motion
