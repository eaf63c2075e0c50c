#include <algorithm>
#include <cmath>

#include "motion/foot_plant.h"

namespace promenade::motion {
namespace {

using Body = Eigen::Matrix<double, 3, body_joint_count>;

double most(const Body& difference) { return difference.colwise().norm().maxCoeff(); }

double ground_distance(const Body& a, const Body& b, BodyJoint joint) {
  return std::hypot(a(0, joint) - b(0, joint), a(2, joint) - b(2, joint));
}

}  // namespace

Eigen::Matrix<double, 3, body_joint_count> body_over_ground(const MotionSet& set,
                                                            const Cycle& cycle, double seconds) {
  const Pose pose = pose_at(set, cycle, phase_at(set, cycle, seconds));
  Body body = body_positions(set.body, forward_kinematics(set.skeleton, pose));
  body.row(0).array() += cycle.velocity.x() * seconds;
  body.row(2).array() += cycle.velocity.y() * seconds;
  return body;
}

double stance_slide_m(const MotionSet& set, const Cycle& cycle, Side side) {
  const bool left = side == Side::left;
  const LegJoints leg = leg_joints(side);
  const double on = left ? cycle.keytimes[3] : cycle.keytimes[1];
  const double off = left ? cycle.keytimes[2] + cycle.seconds : cycle.keytimes[4];
  constexpr int steps = 60;
  double slide = 0;
  Body before = body_over_ground(set, cycle, on);
  for (int k = 1; k <= steps; ++k) {
    const Body now = body_over_ground(set, cycle, on + (off - on) * k / steps);
    slide +=
        std::min(ground_distance(before, now, leg.ankle), ground_distance(before, now, leg.toe));
    before = now;
  }
  return slide;
}

Seam seam(const MotionSet& set, const Cycle& cycle) {
  Seam result;
  const int steps = std::max(static_cast<int>(std::lround(cycle.seconds / result.step_s)), 4);
  result.step_s = cycle.seconds / steps;
  const auto at = [&](int k) { return body_over_ground(set, cycle, k * result.step_s); };
  Body before = at(-1), now = at(0);
  for (int k = 0; k < steps; ++k) {
    const Body after = at(k + 1);
    const double gap = most(before - 2 * now + after);
    (k == 0 ? result.gap_m : result.inside_m) =
        std::max(k == 0 ? result.gap_m : result.inside_m, gap);
    before = now;
    now = after;
  }
  const double instant = 1e-9 * cycle.seconds;
  result.position_m =
      most(body_over_ground(set, cycle, instant) - body_over_ground(set, cycle, -instant));
  result.velocity_m_s = result.gap_m / result.step_s;
  return result;
}

}  // namespace promenade::motion
