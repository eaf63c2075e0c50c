#include "motion/graph/transition_lay.h"

#include <cmath>
#include <optional>

namespace promenade::motion {
namespace {

using Eigen::Matrix2Xd;
using Eigen::Vector2d;
using Eigen::Vector3d;

// How B is moved over the ground: turned about `centre`, and shifted.
struct Nudge {
  Vector2d centre;
  Vector3d change = Vector3d::Zero();  // x, z, metres; the angle, radians

  PlanarMove after_match(const PlanarMove& match) const {
    const PlanarMove there{0, -centre.x(), -centre.y()};
    const PlanarMove back{change.z(), centre.x() + change.x(), centre.y() + change.y()};
    return after(back, after(there, match));
  }
};

// A standing foot is off by `drift` at its end (or was at its beginning), at a place that moves
// with B by this share; and how much it hurts.
struct Pull {
  Vector2d drift, place;
  double share, weight;
};

// A shift s that fades within n frames bends the way of a foot by 6 s / n^2 from frame to frame.
double hurt(int frames) { return 1 / std::pow(frames, 4); }

// A foot that cannot fade at all, against those that can.
constexpr double firm = 1e6;

// Turning B by a radian hurts as shifting it by so many metres does: people see where a walk goes.
constexpr double turn_metres = 1;

constexpr int most_passes = 3;  // what follows is nearly linear

std::optional<Pull> pull_of(const Blend& blend, const StandingRun& run, const Matrix2Xd& steps,
                            const std::vector<Ground>& ground) {
  const double from = blend.share[static_cast<std::size_t>(run.from)];
  const double to = blend.share[static_cast<std::size_t>(run.to)];
  const Vector2d drift = steps.middleCols(run.from, run.to - run.from).rowwise().sum();
  const Vector2d begin = ground[static_cast<std::size_t>(run.from)].col(1);
  const Vector2d end = ground[static_cast<std::size_t>(run.to)].col(1);
  if (stands_through(blend, run)) return Pull{drift, end, 1, firm};
  if (run.from == 0) return Pull{drift, end, to, hurt(blend.last() - run.to)};
  if (run.to == blend.last()) return Pull{drift, begin, 1 - from, hurt(run.from)};
  return {};
}

// Least squares: what B must be moved by, beside what it was already.
Vector3d easiest(const Blend& blend, const FootRuns& runs, const Nudge& nudge) {
  // Moving B bends the ways of all joints: it hurts like a foot that fades over all frames.
  const double all = hurt(blend.last());
  const Vector3d stay(all, all, all * turn_metres * turn_metres);
  Eigen::Matrix3d normal = stay.asDiagonal();
  Vector3d right = -stay.cwiseProduct(nudge.change);
  for (std::size_t foot = 0; foot < 2; ++foot) {
    const std::vector<Ground> ground = foot_ground(blend, foot);
    const Matrix2Xd steps = support_steps(blend, foot, runs[foot], ground);
    for (const StandingRun& run : runs[foot]) {
      const std::optional<Pull> pull = pull_of(blend, run, steps, ground);
      if (!pull) continue;
      const Vector2d lever = pull->place - nudge.centre - nudge.change.head<2>();
      Eigen::Matrix<double, 2, 3> moves;
      moves << 1, 0, lever.y(), 0, 1, -lever.x();
      moves *= pull->share;
      normal += pull->weight * moves.transpose() * moves;
      right -= pull->weight * moves.transpose() * pull->drift;
    }
  }
  return normal.ldlt().solve(right);
}

}  // namespace

void lay_by_feet(Blend& blend, const FootRuns& runs) {
  const PlanarMove match = blend.move;
  const Vector3d middle = blend.poses[static_cast<std::size_t>(blend.last() / 2)].root;
  Nudge nudge{Vector2d(middle.x(), middle.z())};
  for (int pass = 0; pass < most_passes; ++pass) {
    const Vector3d more = easiest(blend, runs, nudge);
    if (more.norm() < 1e-6) return;
    nudge.change += more;
    lay(blend, nudge.after_match(match));
  }
}

}  // namespace promenade::motion
