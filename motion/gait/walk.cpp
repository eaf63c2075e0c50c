#include "motion/gait/walk.h"

#include "motion/gait/curve.h"
#include "motion/gait/legs.h"
#include "motion/gait/upper_body.h"

namespace promenade::motion::gait {
namespace {

using Eigen::Quaterniond;
using Eigen::Vector3d;

// Turns in the world, one for each joint of the skeleton, become local ones.
class WorldTurns {
 public:
  explicit WorldTurns(const Skeleton& skeleton)
      : skeleton_(skeleton), turns_(skeleton.joints.size(), Quaterniond::Identity()) {}

  void set(int joint, const Quaterniond& turn) { turns_[static_cast<std::size_t>(joint)] = turn; }

  std::vector<Quaterniond> local() const {
    std::vector<Quaterniond> result = turns_;
    for (std::size_t j = 1; j < turns_.size(); ++j) {
      const auto parent = static_cast<std::size_t>(skeleton_.joints[j].parent);
      result[j] = (turns_[parent].conjugate() * turns_[j]).normalized();
    }
    return result;
  }

 private:
  const Skeleton& skeleton_;
  std::vector<Quaterniond> turns_;
};

// Joints in the order of make_skeleton(): trunk, arms, legs.
constexpr int first_arm_joint = 5;
constexpr int first_leg_joint = 13;
constexpr int limb_joints = 4;

void set_leg(const Walk& walk, Side side, double stride, const Vector3d& pelvis,
             WorldTurns& turns) {
  const GaitStyle& style = walk.style;
  const FootPose foot = foot_pose(style, side, stride);
  const double outward = sign_of(side) * (0.5 * style.feet.toe_out + style.knees.outward);
  const Vector3d ahead = turned(outward, 0, 0) * Vector3d::UnitZ();
  const LegTurns leg = leg_turns(pelvis + hip_offset(style, side, stride), foot.ankle, ahead);
  const int first = first_leg_joint + (side == Side::left ? 0 : limb_joints);
  turns.set(first, leg.thigh);
  turns.set(first + 1, leg.shank);
  turns.set(first + 2, foot.turn);
  turns.set(first + 3, foot.turn * turned(0, -foot.toes_up, 0));
}

void set_arm(const Walk& walk, Side side, double stride, WorldTurns& turns) {
  const ArmTurns arm = arm_turns(walk.style, side, stride);
  const int first = first_arm_joint + (side == Side::left ? 0 : limb_joints);
  turns.set(first, arm.clavicle);
  turns.set(first + 1, arm.upper);
  turns.set(first + 2, arm.fore);
  turns.set(first + 3, arm.hand);
}

}  // namespace

double stride_seconds(const GaitStyle& style) { return 120 / style.timing.cadence; }

double stride_length(const GaitStyle& style) { return style.timing.speed * stride_seconds(style); }

Walk make_walk(GaitStyle style) {
  Walk walk{std::move(style), make_skeleton(), {}};
  walk.height = pelvis_height(walk.style);
  return walk;
}

Pose walking_pose(const Walk& walk, double stride) {
  Pose pose;
  pose.root = pelvis_path(walk.style, stride);
  pose.root.y() = height_at(walk.height, stride);
  WorldTurns turns(walk.skeleton);
  const TrunkTurns trunk = trunk_turns(walk.style, stride);
  turns.set(0, pelvis_turn(walk.style, stride));
  turns.set(1, trunk.spine);
  turns.set(2, trunk.chest);
  turns.set(3, trunk.neck);
  turns.set(4, trunk.head);
  for (const Side side : {Side::left, Side::right}) {
    set_arm(walk, side, stride, turns);
    set_leg(walk, side, stride, pose.root, turns);
  }
  pose.rotations = turns.local();
  return pose;
}

double first_toe_off(const GaitStyle& style) { return style.timing.stance; }

std::vector<double> walking_keytimes(const GaitStyle& style) {
  const double start = first_toe_off(style);
  const double left = style.timing.left_strike;
  const double seconds = stride_seconds(style);
  return {0, (1 - start) * seconds, left * seconds, (left + 1 - start) * seconds, seconds};
}

}  // namespace promenade::motion::gait
