#include "motion/foot_measures.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "motion/heel.h"
#include "motion/quantile.h"

namespace promenade::motion {
namespace {

using Body = Eigen::Matrix<double, 3, body_joint_count>;

double most(const Body& difference) { return difference.colwise().norm().maxCoeff(); }

struct StanceTime {
  double on = 0, off = 0;  // seconds, the second beyond the cycle where it runs over the seam
};

StanceTime stance_time(const Cycle& cycle, Side side) {
  if (side == Side::right) return {cycle.keytimes[1], cycle.keytimes[4]};
  return {cycle.keytimes[3], cycle.keytimes[2] + cycle.seconds};
}

struct Sole {
  Eigen::Vector3d heel, ankle, toe;
  Eigen::Vector3d pad;  // under the heel, on the ground when the foot is flat

  std::array<Eigen::Vector3d, 4> points() const { return {heel, ankle, toe, pad}; }
};

// One foot of a walk over the ground.
class Foot {
 public:
  Foot(const MotionSet& set, const Cycle& cycle, Side side)
      : set_(set), cycle_(cycle), leg_(leg_joints(side)) {
    const StanceTime stance = stance_time(cycle, side);
    Body flat = body_over_ground(set, cycle, stance.on);
    for (int k = 1; k <= 40; ++k) {
      const Body body = body_over_ground(set, cycle, stance.on + (stance.off - stance.on) * k / 40);
      if (body(1, leg_.ankle) < flat(1, leg_.ankle)) flat = body;
    }
    heel_ = find_heel(flat.col(leg_.ankle), flat.col(leg_.toe));
    pad_ = find_heel(flat.col(leg_.ankle), flat.col(leg_.toe), 0);
  }

  Sole sole(double seconds) const {
    const Body body = body_over_ground(set_, cycle_, seconds);
    const Eigen::Vector3d ankle = body.col(leg_.ankle), toe = body.col(leg_.toe);
    return {heel_position(heel_, ankle, toe), ankle, toe, heel_position(pad_, ankle, toe)};
  }

 private:
  const MotionSet& set_;
  const Cycle& cycle_;
  LegJoints leg_;
  Heel heel_, pad_;
};

// Heights of a toe while its foot is flat or leaves, metres. When it lands, the toe is up.
std::vector<double> standing_toe(const MotionSet& set, const Cycle& cycle, Side side) {
  const StanceTime stance = stance_time(cycle, side);
  std::vector<double> heights;
  for (int k = 0; k <= 40; ++k) {
    const double share = 0.25 + 0.75 * k / 40;
    const Body body = body_over_ground(set, cycle, stance.on + share * (stance.off - stance.on));
    heights.push_back(body(1, leg_joints(side).toe));
  }
  return heights;
}

// A toe goes down a little when the heel rises; then the foot stands on it.
constexpr double low_share = 0.1;

// Of shoes and bare feet.
constexpr double least_toe_level = 0.01, most_toe_level = 0.06;

}  // namespace

double floor_level(double toe_level_m) {
  return std::clamp(toe_level_m, least_toe_level, most_toe_level);
}

Eigen::Matrix<double, 3, body_joint_count> body_over_ground(const MotionSet& set,
                                                            const Cycle& cycle, double seconds) {
  const Pose pose = pose_at(set, cycle, phase_at(set, cycle, seconds));
  Body body = body_positions(set.body, forward_kinematics(set.skeleton, pose));
  body.row(0).array() += cycle.velocity.x() * seconds;
  body.row(2).array() += cycle.velocity.y() * seconds;
  return body;
}

double stance_slide_m(const MotionSet& set, const Cycle& cycle, Side side) {
  const StanceTime stance = stance_time(cycle, side);
  const Foot foot(set, cycle, side);
  constexpr int steps = 60;
  double slide = 0;
  auto before = foot.sole(stance.on).points();
  for (int k = 1; k <= steps; ++k) {
    const auto now = foot.sole(stance.on + (stance.off - stance.on) * k / steps).points();
    double least = INFINITY;
    for (std::size_t p = 0; p < now.size(); ++p) {
      least = std::min(least, std::hypot(now[p].x() - before[p].x(), now[p].z() - before[p].z()));
    }
    slide += least;
    before = now;
  }
  return slide;
}

double toe_level(const MotionSet& set, const Cycle& cycle, Side side) {
  return quantile(standing_toe(set, cycle, side), low_share);
}

double toe_level(const MotionSet& set, const Cycle& cycle) {
  return 0.5 * (toe_level(set, cycle, Side::left) + toe_level(set, cycle, Side::right));
}

double penetration_m(const MotionSet& set, const Cycle& cycle) {
  const double level = toe_level(set, cycle);
  double most = 0;
  for (const Side side : {Side::left, Side::right}) {
    const Foot foot(set, cycle, side);
    constexpr int steps = 120;
    for (int k = 0; k < steps; ++k) {
      const Sole sole = foot.sole(cycle.seconds * k / steps);
      most = std::max(most, level - std::min(sole.heel.y(), sole.toe.y()));
    }
  }
  return most;
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
