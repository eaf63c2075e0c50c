#include "motion/take.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "motion/body_topology.h"

namespace promenade::motion {
namespace {

using Eigen::Quaterniond;
using Eigen::Vector3d;
using Eigen::Vector4d;

// Which joints of the clip the take keeps, in order: the pelvis and all below it.
std::vector<int> kept_joints(const Skeleton& skeleton, int pelvis_joint) {
  std::vector<bool> below(skeleton.joints.size(), false);
  std::vector<int> kept;
  for (int j = pelvis_joint; j < skeleton.size(); ++j) {
    const int parent = skeleton.joints[static_cast<std::size_t>(j)].parent;
    const bool keep = j == pelvis_joint || (parent >= 0 && below[static_cast<std::size_t>(parent)]);
    below[static_cast<std::size_t>(j)] = keep;
    if (keep) kept.push_back(j);
  }
  return kept;
}

Skeleton kept_skeleton(const Skeleton& all, const std::vector<int>& kept, double unit_m) {
  std::vector<int> moved(all.joints.size(), -1);
  Skeleton skeleton;
  for (const int j : kept) {
    const Joint& joint = all.joints[static_cast<std::size_t>(j)];
    moved[static_cast<std::size_t>(j)] = skeleton.size();
    const int parent = skeleton.joints.empty() ? -1 : moved[static_cast<std::size_t>(joint.parent)];
    skeleton.joints.push_back({joint.name, parent, Vector3d::Zero()});
  }
  for (const EndSite& site : all.end_sites) {
    const int joint = moved[static_cast<std::size_t>(site.joint)];
    if (joint >= 0) skeleton.end_sites.push_back({joint, unit_m * site.offset});
  }
  return skeleton;
}

BodyMap moved_body(const BodyMap& body, const std::vector<int>& kept) {
  BodyMap moved = body;
  for (int& joint : moved.joint) {
    joint = static_cast<int>(std::lower_bound(kept.begin(), kept.end(), joint) - kept.begin());
  }
  return moved;
}

// Follows `previous`, so that neighbouring quaternions can be interpolated.
Quaterniond near(const Quaterniond& q, const Quaterniond& previous) {
  return q.dot(previous) < 0 ? Quaterniond(Vector4d(-q.coeffs())) : q;
}

Vector4d catmull_rom(const Vector4d& a, const Vector4d& b, const Vector4d& c, const Vector4d& d,
                     double x) {
  const Vector4d slope_b = 0.5 * (c - a);
  const Vector4d slope_c = 0.5 * (d - b);
  const Vector4d bend = 3 * (c - b) - 2 * slope_b - slope_c;
  const Vector4d twist = 2 * (b - c) + slope_b + slope_c;
  return b + x * (slope_b + x * (bend + x * twist));
}

}  // namespace

Take make_take(const Clip& clip, const Figure& figure) {
  const int hips = figure.body.joint[pelvis];
  const std::vector<int> kept = kept_joints(clip.skeleton, hips);
  const Eigen::Matrix3d turn = to_y_up(figure.z_up);
  Take take;
  take.source = clip.file;
  take.skeleton = kept_skeleton(clip.skeleton, kept, figure.unit_m);
  take.body = moved_body(figure.body, kept);
  take.frame_time = clip.frame_time;
  LocalPose local;
  for (int f = 0; f < clip.frames(); ++f) {
    local_pose(clip, f, local);
    const WorldPose world = forward_kinematics(clip, local);
    Pose pose;
    pose.root = figure.unit_m * turn * world.positions.col(hips);
    for (std::size_t k = 0; k < kept.size(); ++k) {
      const auto j = static_cast<std::size_t>(kept[k]);
      Quaterniond q = k == 0 ? Quaterniond(turn) * world.rotations[j] : local.rotations[j];
      if (f > 0) q = near(q, take.poses.back().rotations[k]);
      pose.rotations.push_back(q);
      if (k > 0) take.skeleton.joints[k].offset += local.translations.col(kept[k]);
    }
    take.poses.push_back(std::move(pose));
  }
  for (Joint& joint : take.skeleton.joints) joint.offset *= figure.unit_m / clip.frames();
  return take;
}

Take part(const Take& take, int from, int to) {
  assert(0 <= from && from <= to && to < take.frames() && "frames of the take");
  Take rest{take.source, take.skeleton, take.body, take.frame_time, {}, take.first_frame + from, 0};
  rest.poses.assign(take.poses.begin() + from, take.poses.begin() + to + 1);
  return rest;
}

Pose pose_at(const Take& take, double frame) {
  const int last = take.frames() - 1;
  frame = std::clamp(frame, 0.0, static_cast<double>(last));
  const int b = std::min(static_cast<int>(frame), std::max(last - 1, 0));
  const auto at = [&](int f) -> const Pose& {
    return take.poses[static_cast<std::size_t>(std::clamp(f, 0, last))];
  };
  const Pose &p0 = at(b - 1), &p1 = at(b), &p2 = at(b + 1), &p3 = at(b + 2);
  const double x = frame - b;
  const auto widen = [](const Vector3d& v) { return Vector4d(v.x(), v.y(), v.z(), 0); };
  Pose pose;
  pose.root =
      catmull_rom(widen(p0.root), widen(p1.root), widen(p2.root), widen(p3.root), x).head<3>();
  pose.rotations.reserve(p1.rotations.size());
  for (std::size_t j = 0; j < p1.rotations.size(); ++j) {
    pose.rotations.emplace_back(catmull_rom(p0.rotations[j].coeffs(), p1.rotations[j].coeffs(),
                                            p2.rotations[j].coeffs(), p3.rotations[j].coeffs(), x)
                                    .normalized());
  }
  return pose;
}

Eigen::Matrix<double, 3, body_joint_count> body_at(const Take& take, double frame) {
  return body_positions(take.body, forward_kinematics(take.skeleton, pose_at(take, frame)));
}

Eigen::Matrix2Xd pelvis_way(const Take& take) {
  Eigen::Matrix2Xd way(2, take.frames());
  for (int f = 0; f < take.frames(); ++f) {
    const Vector3d& root = take.poses[static_cast<std::size_t>(f)].root;
    way.col(f) << root.x(), root.z();
  }
  return way;
}

Pose mix(const Pose& a, const Pose& b, double share) {
  Pose pose;
  pose.root = (1 - share) * a.root + share * b.root;
  pose.rotations.reserve(a.rotations.size());
  for (std::size_t j = 0; j < a.rotations.size(); ++j) {
    pose.rotations.push_back(a.rotations[j].slerp(share, b.rotations[j]));
  }
  return pose;
}

}  // namespace promenade::motion
