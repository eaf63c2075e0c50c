#include "motion/gait/upper_body.h"

#include <algorithm>
#include <cmath>

#include "motion/gait/curve.h"
#include "motion/gait/pelvis.h"

namespace promenade::motion::gait {
namespace {

using Eigen::Quaterniond;

constexpr double straightest_elbow = 4;  // degrees: an elbow never overstretches

double chest_yaw(const GaitStyle& style, double stride) {
  return style.trunk.rotation * wave(stride, style.trunk.rotation_peak, style.crispness);
}

Quaterniond chest_turn(const GaitStyle& style, double stride) {
  const Trunk& trunk = style.trunk;
  const double pitch = trunk.lean + trunk.nod * wave(2 * stride, 2 * trunk.nod_peak);
  const double roll =
      -trunk.side_lean + trunk.sway * wave(stride, trunk.sway_peak, style.crispness);
  return turned(chest_yaw(style, stride), pitch, roll);
}

Quaterniond head_turn(const GaitStyle& style, double stride) {
  const Head& head = style.head;
  const double yaw = head.turn + head.follow * chest_yaw(style, stride);
  const double pitch = head.pitch + head.nod * wave(2 * stride, 0.6);
  const double roll = -head.tilt + head.sway * wave(stride, head.sway_peak, style.crispness);
  return turned(yaw, pitch, roll);
}

}  // namespace

TrunkTurns trunk_turns(const GaitStyle& style, double stride) {
  TrunkTurns turns;
  turns.chest = chest_turn(style, stride);
  turns.head = head_turn(style, stride);
  turns.spine = pelvis_turn(style, stride).slerp(0.5 - style.trunk.slump, turns.chest);
  const Quaterniond between = turns.chest.slerp(0.5, turns.head);
  const double pitch = style.head.neck;
  const Eigen::Vector3d up = between * Eigen::Vector3d::UnitY();
  const double leans = std::atan2(up.z(), up.y()) / degree;
  turns.neck = turned(0, pitch - leans, 0) * between;
  return turns;
}

ArmTurns arm_turns(const GaitStyle& style, Side side, double stride) {
  const bool left = side == Side::left;
  const Arms arms = left ? style.left_arm.value_or(style.arms) : style.arms;
  const double x = sign_of(side);
  const double front = (left ? 0.0 : 0.5) + arms.lag;
  const double swing = wave(stride, front, style.crispness);
  const double bend = wave(stride, front + arms.elbow_lag, style.crispness);
  const double drop = wave(stride, front + 2 * arms.elbow_lag, style.crispness);
  const double mean = std::max(arms.elbow, straightest_elbow);
  const double elbow = mean + std::min(arms.elbow_swing, mean - straightest_elbow) * bend;
  const double yaw = chest_yaw(style, stride);

  ArmTurns turns;
  turns.clavicle = chest_turn(style, stride) *
                   turned(-x * (arms.forward + 0.1 * arms.swing * swing), 0, x * arms.raise);
  turns.upper = turned(0.6 * yaw, 0, x * arms.outward) *
                turned(0, -(arms.centre + arms.swing * swing), 0) * turned(-x * arms.twist, 0, 0);
  turns.fore = turns.upper * turned(0, -elbow, 0);
  turns.hand = turns.fore * turned(0, -0.4 * (arms.wrist + arms.wrist_swing * drop),
                                   -x * (arms.wrist + arms.wrist_swing * drop));
  return turns;
}

}  // namespace promenade::motion::gait
