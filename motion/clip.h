// A capture as its file holds it: units, axes and joint order of the file. The
// channel values are kept as they stand, so that memory follows the file's size;
// poses are made from them one frame at a time.
#pragma once

#include <optional>

#include "motion/problem.h"
#include "motion/skeleton.h"

namespace promenade::motion {

enum class Channel : std::uint8_t {
  x_position,
  y_position,
  z_position,
  x_rotation,
  y_rotation,
  z_rotation
};

std::string_view channel_name(Channel channel);  // "Xposition"
inline bool is_rotation(Channel channel) { return channel >= Channel::x_rotation; }

struct JointChannels {
  std::vector<Channel> channels;  // in the order of the file: rotations multiply in it
  int first_row = 0;              // of Clip::values
};

// What a joint's rotations stand between: before * rotations * after.
struct JointAxes {
  Eigen::Quaterniond before = Eigen::Quaterniond::Identity();
  Eigen::Quaterniond after = Eigen::Quaterniond::Identity();
};

struct Clip {
  std::string file;
  std::string format;                   // "bvh" or "asf/amc"
  Skeleton skeleton;                    // offsets in file units
  std::vector<JointChannels> channels;  // J
  // J, or empty. Empty (BVH): rotations multiply from left to right, about axes that
  // turn along. Else (ASF): from right to left, about fixed axes, which are the joint's.
  std::vector<JointAxes> axes;
  Eigen::MatrixXd values;        // C x T: file units and degrees
  double frame_time = 0;         // seconds
  std::optional<double> unit_m;  // metres per file unit, when the file says so
  std::vector<Problem> warnings;

  int frames() const { return static_cast<int>(values.cols()); }
};

// One frame: what every joint does in its parent's frame.
struct LocalPose {
  std::vector<Eigen::Quaterniond> rotations;  // J
  Eigen::Matrix3Xd translations;              // 3 x J, file units; position channels
                                              // replace that component of the offset
};

LocalPose local_pose(const Clip& clip, int frame);

// The same; allocation-free when `pose` has J joints already.
void local_pose(const Clip& clip, int frame, LocalPose& pose);

// World positions in file units and axes.
WorldPose forward_kinematics(const Clip& clip, int frame);
WorldPose forward_kinematics(const Clip& clip, const LocalPose& pose);

}  // namespace promenade::motion
