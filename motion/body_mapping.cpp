#include "motion/body_mapping.h"

#include <algorithm>
#include <cmath>

#include "motion/body_topology.h"

namespace promenade::motion {
namespace {

using Eigen::Vector3d;

void note(const Clip& clip, Figure& figure, std::string message) {
  figure.notes.push_back({clip.file, 0, 0, std::move(message), Severity::warning});
}

const std::string& name_of(const Clip& clip, int joint) {
  return clip.skeleton.joints[static_cast<std::size_t>(joint)].name;
}

// Poses spread over the clip: enough to see how it stands and how long it is.
std::vector<WorldPose> sample_poses(const Clip& clip) {
  constexpr int most = 65;
  const int count = std::min(most, clip.frames());
  std::vector<WorldPose> poses;
  for (int i = 0; i < count; ++i) {
    const auto frame = count == 1 ? 0 : std::int64_t{i} * (clip.frames() - 1) / (count - 1);
    poses.push_back(forward_kinematics(clip, static_cast<int>(frame)));
  }
  return poses;
}

// J, file units: mean distance of every joint to its parent.
Eigen::VectorXd bone_lengths(const Clip& clip, const std::vector<WorldPose>& poses) {
  Eigen::VectorXd lengths = Eigen::VectorXd::Zero(clip.skeleton.size());
  for (int j = 1; j < clip.skeleton.size(); ++j) {
    const int parent = clip.skeleton.joints[static_cast<std::size_t>(j)].parent;
    for (const WorldPose& pose : poses) {
      lengths(j) += (pose.positions.col(j) - pose.positions.col(parent)).norm();
    }
  }
  return lengths / static_cast<double>(poses.size());
}

// Fills in what follows from the tree, and lends what is missing.
BodyMap complete(const Clip& clip, const NamedJoints& found, Figure& figure) {
  const Skeleton& skeleton = clip.skeleton;
  BodyMap body;
  body.joint = found;
  body.joint[pelvis] = common_ancestor(skeleton, found[left_hip], found[right_hip]);
  body.joint[chest] = -1;
  if (found[left_shoulder] >= 0 && found[right_shoulder] >= 0) {
    const int meet = common_ancestor(skeleton, found[left_shoulder], found[right_shoulder]);
    if (meet > body.joint[pelvis]) body.joint[chest] = meet;
  }
  std::string borrowed;
  for (int b = 1; b < body_joint_count; ++b) {
    const auto part = static_cast<std::size_t>(b);
    int& joint = body.joint[part];
    if (joint >= 0 && is_below(skeleton, joint, body.joint[pelvis])) continue;
    joint = body.joint[static_cast<std::size_t>(body_parent(static_cast<BodyJoint>(b)))];
    body.borrowed[part] = true;
    borrowed +=
        (borrowed.empty() ? "" : ", ") + std::string(body_joint_name(static_cast<BodyJoint>(b)));
  }
  if (!borrowed.empty())
    note(clip, figure, "placed by their parents, having no joint: " + borrowed);
  return body;
}

Vector3d at(const WorldPose& pose, const BodyMap& body, BodyJoint part) {
  return pose.positions.col(body.joint[part]);
}

// From the ankles to the pelvis, mean over the clip: up, in the file's axes.
Vector3d standing_direction(const std::vector<WorldPose>& poses, const BodyMap& body) {
  Vector3d sum = Vector3d::Zero();
  for (const WorldPose& pose : poses) {
    sum +=
        at(pose, body, pelvis) - 0.5 * (at(pose, body, left_ankle) + at(pose, body, right_ankle));
  }
  return sum;
}

void find_up(const Clip& clip, const std::vector<WorldPose>& poses, const FigureOptions& options,
             Figure& figure) {
  const Vector3d standing = standing_direction(poses, figure.body).cwiseAbs();
  figure.z_up = options.z_up.value_or(standing.z() > standing.y());
  if (standing.x() > std::max(standing.y(), standing.z())) {
    note(clip, figure, "the figure lies along X: neither Y nor Z is up");
  }
}

void find_unit(const Clip& clip, const Eigen::VectorXd& bones, const FigureOptions& options,
               Figure& figure) {
  double leg = 0;  // of both, file units
  for (const auto& [from, to] : {std::pair{left_hip, left_ankle}, {right_hip, right_ankle}}) {
    int j = figure.body.joint[to];
    for (; j != figure.body.joint[from];
         j = clip.skeleton.joints[static_cast<std::size_t>(j)].parent) {
      leg += 0.5 * bones(j);
    }
  }
  if (!(leg > 0)) throw InputError(clip.file, "the legs have no length");
  if (options.unit_m || clip.unit_m) {
    figure.unit_m = options.unit_m ? *options.unit_m : *clip.unit_m;
  } else {
    double least = INFINITY;
    for (const double unit : {1.0, 0.01, 0.0254, 0.001, 0.0254 / 0.45}) {
      const double misfit = std::abs(std::log(leg * unit / 0.85));
      if (misfit < least) figure.unit_m = unit;
      least = std::min(least, misfit);
    }
    // Two decimals of a leg in metres say enough and do not depend on a locale.
    const int centimetres = static_cast<int>(std::lround(100 * leg * figure.unit_m));
    note(clip, figure,
         "the file does not say its unit; guessed from the legs, which become " +
             std::to_string(centimetres) + " cm long");
  }
  figure.leg_m = leg * figure.unit_m;
}

// Where the feet point, and where the right hip sees the left one, over the clip.
struct Facing {
  Vector3d ahead, left;
};

Facing find_facing(const std::vector<WorldPose>& poses, const Figure& figure) {
  const Eigen::Matrix3d turn = to_y_up(figure.z_up);
  const BodyMap& body = figure.body;
  Facing facing{Vector3d::Zero(), Vector3d::Zero()};
  double agree = 0;
  for (const WorldPose& pose : poses) {
    const Vector3d toes = at(pose, body, left_toe) - at(pose, body, left_ankle) +
                          at(pose, body, right_toe) - at(pose, body, right_ankle);
    Vector3d ahead = turn * toes;
    ahead.y() = 0;
    const Vector3d left = turn * (at(pose, body, left_hip) - at(pose, body, right_hip));
    facing.ahead += ahead;
    facing.left += left;
    agree += Vector3d::UnitY().cross(ahead).dot(left);
  }
  if (agree < 0) facing.left = Vector3d::Zero();  // says that the sides are swapped
  return facing;
}

void swap_sides(BodyMap& body) {
  for (const BodyJoint first : {left_clavicle, left_shoulder, left_elbow, left_wrist, left_hip,
                                left_knee, left_ankle, left_toe}) {
    std::swap(body.joint[first], body.joint[first + 4u]);
    std::swap(body.borrowed[first], body.borrowed[first + 4u]);
  }
}

void find_heading(const Clip& clip, const Vector3d& facing, Figure& figure) {
  const Eigen::Matrix3d turn = to_y_up(figure.z_up) * figure.unit_m;
  const auto pelvis_at = [&](int frame) -> Vector3d {
    return turn * at(forward_kinematics(clip, frame), figure.body, pelvis);
  };
  const Vector3d travel = pelvis_at(clip.frames() - 1) - pelvis_at(0);
  const Eigen::Vector2d over_ground(travel.x(), travel.z());
  figure.travel_m = over_ground.norm();
  const bool walks = figure.travel_m > 0.5 * figure.leg_m;
  const Eigen::Vector2d heading = walks ? over_ground : Eigen::Vector2d(facing.x(), facing.z());
  if (heading.norm() > 0) figure.heading = heading.normalized();
}

BodyMap find_body(const Clip& clip, const Eigen::VectorXd& bones, Figure& figure, bool& by_name) {
  NamedJoints found = joints_by_name(clip.skeleton);
  by_name = legs_are_whole(clip.skeleton, found);
  if (!by_name) {
    found = joints_by_topology(clip.skeleton, bones);
    if (!legs_are_whole(clip.skeleton, found)) {
      throw InputError(clip.file,
                       "there is no body with two legs in it: hips, knees and ankles "
                       "were found neither by name nor in the tree of joints");
    }
    note(clip, figure,
         "the names of the joints say nothing; parts of the body were told by "
         "the lengths of bones");
  }
  return complete(clip, found, figure);
}

}  // namespace

Eigen::Matrix3d to_y_up(bool z_up) {
  if (!z_up) return Eigen::Matrix3d::Identity();
  return (Eigen::Matrix3d() << 1, 0, 0, 0, 0, 1, 0, -1, 0).finished();
}

Figure find_figure(const Clip& clip, const FigureOptions& options) {
  const std::vector<WorldPose> poses = sample_poses(clip);
  const Eigen::VectorXd bones = bone_lengths(clip, poses);
  Figure figure;
  bool by_name = true;
  figure.body = find_body(clip, bones, figure, by_name);
  find_up(clip, poses, options, figure);
  find_unit(clip, bones, options, figure);
  Facing facing = find_facing(poses, figure);
  if (facing.left.isZero() && !by_name) {
    swap_sides(figure.body);
  } else if (facing.left.isZero() && !figure.body.borrowed[left_toe]) {
    note(clip, figure,
         "what is named left stands at the right of the direction of the toes: " +
             name_of(clip, figure.body.joint[left_hip]));
  }
  find_heading(clip, facing.ahead, figure);
  figure.t_pose_frames = frames_in_t_pose(clip, figure.body, figure.z_up);
  figure.gaps = find_gaps(clip);
  const std::vector<Problem> blemishes =
      describe_blemishes(clip, figure.t_pose_frames, figure.gaps);
  figure.notes.insert(figure.notes.end(), blemishes.begin(), blemishes.end());
  return figure;
}

}  // namespace promenade::motion
