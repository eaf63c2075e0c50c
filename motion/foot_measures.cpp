#include <algorithm>
#include <array>
#include <cmath>

#include "motion/foot_plant.h"
#include "motion/heel.h"

namespace promenade::motion {
namespace {

using Body = Eigen::Matrix<double, 3, body_joint_count>;

double most(const Body& difference) { return difference.colwise().norm().maxCoeff(); }

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
  const Body flat = body_over_ground(set, cycle, 0.5 * (on + off));
  const Heel heel = find_heel(flat.col(leg.ankle), flat.col(leg.toe));
  const auto sole = [&](double seconds) {
    const Body body = body_over_ground(set, cycle, seconds);
    const Eigen::Vector3d ankle = body.col(leg.ankle), toe = body.col(leg.toe);
    return std::array{heel_position(heel, ankle, toe), ankle, toe};
  };
  constexpr int steps = 60;
  double slide = 0;
  auto before = sole(on);
  for (int k = 1; k <= steps; ++k) {
    const auto now = sole(on + (off - on) * k / steps);
    double least = INFINITY;
    for (std::size_t p = 0; p < now.size(); ++p) {
      least = std::min(least, std::hypot(now[p].x() - before[p].x(), now[p].z() - before[p].z()));
    }
    slide += least;
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
