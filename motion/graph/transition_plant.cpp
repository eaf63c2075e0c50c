#include "motion/graph/transition_plant.h"

#include <algorithm>
#include <cmath>

#include "motion/angles.h"
#include "motion/fade.h"

namespace promenade::motion {
namespace {

using Eigen::Matrix2Xd;
using Eigen::Vector2d;
using Eigen::Vector3d;

// A leg that was not straighter before reaches at most this share of its length: nearer to
// straight, a few millimetres turn a knee by many degrees.
constexpr double most_reach = 0.99;
constexpr double cover_seconds = 0.1;  // over which the pelvis comes down and up again
constexpr double least_bearing = 0.1;  // of the pelvis, by a foot that swings

// 2 x frames of the run: how far the foot must be moved so that its supporting point stays.
Matrix2Xd standing_shift(const Blend& blend, const StandingRun& run, const Matrix2Xd& steps) {
  Matrix2Xd shift(2, run.to - run.from + 1);
  shift.col(0).setZero();
  for (Eigen::Index q = 1; q < shift.cols(); ++q) {
    shift.col(q) = shift.col(q - 1) - steps.col(run.from + q - 1);
  }
  const Vector2d end = shift.col(shift.cols() - 1);
  if (stands_through(blend, run)) {
    // What is left where two feet stand otherwise apart in B: they slide as evenly as can be.
    for (int q = 0; q <= blend.last(); ++q) {
      shift.col(q) -= blend.share[static_cast<std::size_t>(q)] * end;
    }
  } else if (run.to == blend.last()) {
    shift.colwise() -= end;
  } else if (run.from > 0) {
    const Vector2d mean = shift.rowwise().mean();
    shift.colwise() -= mean;
  }
  return shift;
}

// What a swinging foot goes over from or to: metres, and metres per second.
struct Anchor {
  int frame;
  Vector2d shift = Vector2d::Zero(), velocity = Vector2d::Zero();
};

void fade_between(const Anchor& from, const Anchor& to, double frame_time, Matrix2Xd& shift) {
  const Fade<Vector2d> fade{(to.frame - from.frame) * frame_time, from.shift, to.shift,
                            from.velocity, to.velocity};
  for (int q = from.frame + 1; q < to.frame; ++q) {
    shift.col(q) = fade.at((q - from.frame) * frame_time);
  }
}

// 2 x (k + 1), metres: how far a foot is moved over the ground, zero at both ends.
Matrix2Xd foot_shift(const Blend& blend, std::size_t foot, const std::vector<StandingRun>& runs) {
  const double frame_time = blend.a.take.frame_time;
  const Matrix2Xd steps = support_steps(blend, foot, runs, foot_ground(blend, foot));
  Matrix2Xd shift = Matrix2Xd::Zero(2, blend.last() + 1);
  Anchor before{0};
  for (const StandingRun& run : runs) {
    const Matrix2Xd stood = standing_shift(blend, run, steps);
    const Eigen::Index end = stood.cols() - 1;
    Anchor on{run.from, stood.col(0)}, off{run.to, stood.col(end)};
    if (end > 0) {
      on.velocity = (stood.col(1) - stood.col(0)) / frame_time;
      off.velocity = (stood.col(end) - stood.col(end - 1)) / frame_time;
    }
    fade_between(before, on, frame_time, shift);
    shift.middleCols(run.from, end + 1) = stood;
    before = off;
  }
  fade_between(before, {blend.last()}, frame_time, shift);
  return shift;
}

// 0 to 1: how much the pelvis is carried by a foot.
double bearing(const Blend& blend, std::size_t foot, int q) {
  const double inside = standing_depth(blend, foot, q, &FootedLeg::standing);
  return least_bearing + 0.5 + 0.5 * inside * blend.a.take.frame_time / most_inside_seconds;
}

// Where the feet and the pelvis go: 2 x (k + 1) over the ground, and how far down.
struct Changes {
  std::array<Matrix2Xd, 2> feet;
  Matrix2Xd pelvis;
  std::vector<double> low;
};

// The pelvis goes along with the foot that carries it, so that its knee need not change.
Matrix2Xd pelvis_shift(const Blend& blend, const std::array<Matrix2Xd, 2>& feet) {
  Matrix2Xd shift = Matrix2Xd::Zero(2, blend.last() + 1);
  for (int q = 1; q < blend.last(); ++q) {
    const double left = bearing(blend, 0, q), right = bearing(blend, 1, q);
    shift.col(q) = (left * feet[0].col(q) + right * feet[1].col(q)) / (left + right);
  }
  return shift;
}

// How far the pelvis must come down so that a leg reaches when its foot is moved, seen from the
// hip.
double lowering(const Blend& blend, std::size_t foot, int q, const Vector2d& shift) {
  const LegJoints leg = leg_joints(foot_sides[foot]);
  const Vector3d hip = blend.place(q, leg.hip), knee = blend.place(q, leg.knee);
  const Vector3d ankle = blend.place(q, leg.ankle);
  const double length = (knee - hip).norm() + (ankle - knee).norm();
  const double most = std::max((ankle - hip).norm(), most_reach * length);
  const Vector3d way = ankle - hip + Vector3d(shift.x(), 0, shift.y());
  if (way.norm() <= most) return 0;
  const double across = std::hypot(way.x(), way.z());
  return -way.y() - std::sqrt(std::max(most * most - across * across, 0.0));
}

// Not less than the values, and smooth; zero at both ends.
std::vector<double> smooth_cover(const std::vector<double>& values, int reach) {
  const int size = static_cast<int>(values.size());
  const auto around = [&](int q, const auto& visit) {
    for (int g = std::max(q - reach + 1, 0); g < std::min(q + reach, size); ++g) {
      visit(static_cast<std::size_t>(g), 0.5 + 0.5 * std::cos(pi * (g - q) / reach));
    }
  };
  std::vector<double> covered(values.size(), 0), smooth(values.size(), 0);
  for (int q = 0; q < size; ++q) {
    double& most = covered[static_cast<std::size_t>(q)];
    around(q, [&](std::size_t g, double) { most = std::max(most, values[g]); });
  }
  for (int q = 0; q < size; ++q) {
    double sum = 0, weights = 0;
    around(q, [&](std::size_t g, double weight) {
      sum += weight * covered[g];
      weights += weight;
    });
    const double x = std::min(std::min(q, size - 1 - q) / static_cast<double>(reach), 1.0);
    smooth[static_cast<std::size_t>(q)] = x * x * (3 - 2 * x) * sum / weights;
  }
  return smooth;
}

std::vector<double> pelvis_lowering(const Blend& blend, const Changes& changes) {
  std::vector<double> low(blend.share.size(), 0);
  for (int q = 1; q < blend.last(); ++q) {
    for (std::size_t foot = 0; foot < 2; ++foot) {
      const Vector2d shift = changes.feet[foot].col(q) - changes.pelvis.col(q);
      double& most = low[static_cast<std::size_t>(q)];
      most = std::max(most, lowering(blend, foot, q, shift));
    }
  }
  const auto reach = std::lround(cover_seconds / blend.a.take.frame_time);
  if (std::all_of(low.begin(), low.end(), [](double value) { return value == 0; })) return low;
  return smooth_cover(low, std::max(static_cast<int>(reach), 1));
}

// Moves what is below the pelvis back to where the feet are wanted.
void move_feet(Blend& blend, const Changes& changes, int q) {
  const auto f = static_cast<std::size_t>(q);
  Pose& pose = blend.poses[f];
  WorldPose& figure = blend.figures[f];
  const Eigen::Quaterniond home = pose.rotations[0].conjugate();
  for (std::size_t foot = 0; foot < 2; ++foot) {
    const Vector2d shift = changes.feet[foot].col(q) - changes.pelvis.col(q);
    if (shift.isZero(0) && changes.low[f] == 0) continue;
    const int ankle = blend.body().joint[leg_joints(foot_sides[foot]).ankle];
    const FootTarget target{
        figure.positions.col(ankle) + home * Vector3d(shift.x(), changes.low[f], shift.y()),
        figure.rotations[static_cast<std::size_t>(ankle)]};
    move_foot(blend.skeleton(), blend.body(), foot_sides[foot], blend.knees[foot], target, figure,
              pose);
  }
  look(blend, q);
}

}  // namespace

double plant_feet(Blend& blend, const FootRuns& runs) {
  Changes changes;
  for (std::size_t foot = 0; foot < 2; ++foot) {
    changes.feet[foot] = foot_shift(blend, foot, runs[foot]);
  }
  changes.pelvis = pelvis_shift(blend, changes.feet);
  changes.low = pelvis_lowering(blend, changes);
  double most = 0;
  for (int q = 1; q < blend.last(); ++q) {
    const double low = changes.low[static_cast<std::size_t>(q)];
    blend.poses[static_cast<std::size_t>(q)].root +=
        Vector3d(changes.pelvis(0, q), -low, changes.pelvis(1, q));
    move_feet(blend, changes, q);
    for (const Matrix2Xd& foot : changes.feet) most = std::max(most, foot.col(q).norm());
  }
  return most;
}

}  // namespace promenade::motion
