// A skeleton is a tree of joints in an order where parents come first; a pose
// turns its joints. Y is up, metres, right-handed: a figure that faces +Z has
// +X at its left.
#pragma once

#include <Eigen/Dense>
#include <Eigen/Geometry>
#include <string>
#include <vector>

namespace promenade::motion {

struct Joint {
  std::string name;
  int parent = -1;                                   // -1: the root, always joint 0
  Eigen::Vector3d offset = Eigen::Vector3d::Zero();  // from the parent, in its frame
};

// A tip without a joint (head top, finger, toe), for drawing and export.
struct EndSite {
  int joint = 0;
  Eigen::Vector3d offset = Eigen::Vector3d::Zero();
};

struct Skeleton {
  std::vector<Joint> joints;
  std::vector<EndSite> end_sites;

  int size() const { return static_cast<int>(joints.size()); }
};

// Index of the joint with this name, or -1.
int find_joint(const Skeleton& skeleton, const std::string& name);

struct Pose {
  Eigen::Vector3d root = Eigen::Vector3d::Zero();  // position of joint 0, metres
  std::vector<Eigen::Quaterniond> rotations;       // J, local: child frame to parent frame
};

// Where every joint is, and how it is turned, in the world.
struct WorldPose {
  Eigen::Matrix3Xd positions;                 // 3 x J, metres
  std::vector<Eigen::Quaterniond> rotations;  // J
};

WorldPose forward_kinematics(const Skeleton& skeleton, const Pose& pose);

// The same; allocation-free when `world` has J joints already.
void forward_kinematics(const Skeleton& skeleton, const Pose& pose, WorldPose& world);

}  // namespace promenade::motion
