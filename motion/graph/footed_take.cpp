#include "motion/graph/footed_take.h"

#include <algorithm>
#include <cmath>

namespace promenade::motion {
namespace {

constexpr double toe_slack_m_s = 0.05;  // toes of feet that stand are slower

// T: how far each frame is inside of a stance.
std::vector<double> inside(const Take& take, const std::vector<Stance>& stances,
                           double Stance::*begin) {
  const double most = most_inside_seconds / take.frame_time;
  std::vector<double> depth(take.poses.size(), -most);
  for (std::size_t f = 0; f < depth.size(); ++f) {
    const auto frame = static_cast<double>(f);
    for (const Stance& stance : stances) {
      const double since = stance.on <= 0 ? INFINITY : frame - stance.*begin;
      const double left = stance.off >= take.frames() - 1 ? INFINITY : stance.off - frame;
      depth[f] = std::clamp(std::min(since, left), depth[f], most);
    }
  }
  return depth;
}

Ground ground_of(const Take& take, const WorldPose& world, std::size_t foot, const Heel& heel) {
  const LegJoints leg = leg_joints(foot_sides[foot]);
  return ground_under(heel, world.positions.col(take.body.joint[leg.ankle]),
                      world.positions.col(take.body.joint[leg.toe]));
}

// Supports and steps.
void find_steps(const Take& take, std::array<FootedLeg, 2>& legs) {
  for (FootedLeg& leg : legs) leg.steps.resize(2, std::max(take.frames() - 1, 0));
  const double slack = toe_slack_m_s * take.frame_time;
  std::array<Ground, 2> before;
  WorldPose world;
  for (int f = 0; f < take.frames(); ++f) {
    forward_kinematics(take.skeleton, take.poses[static_cast<std::size_t>(f)], world);
    for (std::size_t foot = 0; foot < 2; ++foot) {
      const Ground now = ground_of(take, world, foot, legs[foot].heel);
      if (f > 0) {
        legs[foot].support.push_back(support_of(now - before[foot], slack));
        legs[foot].steps.col(f - 1) =
            (now - before[foot]).col(static_cast<Eigen::Index>(legs[foot].support.back()));
      }
      before[foot] = now;
    }
  }
}

FootedLeg make_leg(const Take& take, const Eigen::Vector3d& knee, const Heel& heel,
                   const std::vector<Stance>& stances) {
  return {knee, heel, inside(take, stances, &Stance::on), inside(take, stances, &Stance::still),
          {},   {}};
}

}  // namespace

Ground ground_under(const Heel& heel, const Eigen::Vector3d& ankle, const Eigen::Vector3d& toe) {
  const Eigen::Vector3d back = heel_position(heel, ankle, toe);
  Ground ground;
  ground << back.x(), ankle.x(), toe.x(), back.z(), ankle.z(), toe.z();
  return ground;
}

Support support_of(const Ground& step, double slack) {
  Eigen::Index least = 0;
  const Eigen::RowVector3d ways = step.colwise().norm();
  ways.minCoeff(&least);
  return ways(2) <= ways(least) + slack ? Support::toe : static_cast<Support>(least);
}

FootedTake make_footed(const Take& take) { return make_footed(take, find_contacts(take)); }

FootedTake make_footed(const Take& take, const FootContacts& contacts) {
  const KneeAxes axes = knee_axes(take);
  FootedTake footed{take,
                    {make_leg(take, axes[0], contacts.left_heel, contacts.left),
                     make_leg(take, axes[1], contacts.right_heel, contacts.right)},
                    frame_gaps(take, axes)};
  find_steps(take, footed.legs);
  return footed;
}

}  // namespace promenade::motion
