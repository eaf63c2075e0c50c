#include "motion/motion_space.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cassert>
#include <cmath>

#include "motion/canonical.h"
#include "motion/rotation.h"

namespace promenade::motion {
namespace {

using Eigen::Quaterniond;
using Eigen::Vector3d;
using Eigen::Vector4d;

// The leading eigenvector of sum q q^T: free of order and sign.
Vector4d mean_rotation(const MotionSet& set, int column) {
  Eigen::Matrix4d sum = Eigen::Matrix4d::Zero();
  for (const Cycle& cycle : set.cycles) {
    const Vector4d q = cycle.rotations.col(column);
    sum += q * q.transpose();
  }
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix4d> solver(sum);
  const Vector4d mean = solver.eigenvectors().col(3);
  return mean(3) < 0 ? Vector4d(-mean) : mean;
}

// Mean planar velocity between neighbouring phases, per unit of normalised time,
// in metres: 2 x F.
Eigen::Matrix2Xd phase_velocity(const MotionSet& set, const Cycle& cycle) {
  const Eigen::VectorXd times = normalised_times(set, cycle);
  Eigen::Matrix2Xd velocity(2, set.phases);
  for (int f = 0; f < set.phases; ++f) {
    const Vector3d step = cycle.root.col((f + 1) % set.phases) - cycle.root.col(f);
    velocity.col(f) = Eigen::Vector2d(step.x(), step.z()) / (times(f + 1) - times(f)) +
                      cycle.velocity * cycle.seconds;
  }
  return velocity;
}

// Integrates planar velocities (2 x F, metres per unit of normalised time).
void integrate(const MotionSet& set, const Eigen::Matrix2Xd& velocity, Cycle& cycle) {
  const Eigen::VectorXd times = normalised_times(set, cycle);
  Eigen::Matrix2Xd path(2, set.phases + 1);
  path.col(0).setZero();
  for (int f = 0; f < set.phases; ++f) {
    path.col(f + 1) = path.col(f) + velocity.col(f) * (times(f + 1) - times(f));
  }
  set_planar_path(set, path, cycle);
}

void blend_rotations(const MotionSpace& space, const Eigen::VectorXd& x, Cycle& cycle) {
  const Eigen::Index columns = space.average.cols();
  cycle.rotations.resize(4, columns);
  for (Eigen::Index c = 0; c < columns; ++c) {
    const Quaterniond mean(Vector4d(space.average.col(c)));
    cycle.rotations.col(c) = (mean * exp_of(x.segment<3>(3 * c))).normalized().coeffs();
  }
}

}  // namespace

int MotionSpace::shape_rows() const { return set.phases * (3 * set.skeleton.size() + 1); }

MotionSpace make_motion_space(MotionSet set) {
  assert(set.size() > 0 && "a motion set has cycles");
  MotionSpace space;
  const int columns = set.phases * set.skeleton.size();
  space.leg_length = leg_length(set.skeleton, set.body);
  space.average.resize(4, columns);
  for (int c = 0; c < columns; ++c) space.average.col(c) = mean_rotation(set, c);
  space.mean_height = Eigen::VectorXd::Zero(set.phases);
  for (const Cycle& cycle : set.cycles) space.mean_height += cycle.root.row(1).transpose();
  space.mean_height /= set.size();

  space.offsets.resize(3 * columns + 3 * set.phases, set.size());
  for (int i = 0; i < set.size(); ++i) {
    const Cycle& cycle = set.cycles[static_cast<std::size_t>(i)];
    for (int c = 0; c < columns; ++c) {
      const Quaterniond mean(Vector4d(space.average.col(c)));
      const Quaterniond own(Vector4d(cycle.rotations.col(c)));
      space.offsets.col(i).segment<3>(3 * c) = log_of(mean.conjugate() * own);
    }
    space.offsets.col(i).segment(3 * columns, set.phases) =
        (cycle.root.row(1).transpose() - space.mean_height) / space.leg_length;
    space.offsets.col(i).tail(2 * set.phases) =
        phase_velocity(set, cycle).reshaped() / space.leg_length;
  }
  space.set = std::move(set);
  return space;
}

void blend_keytimes(const MotionSet& set, const Eigen::VectorXd& weights,
                    std::vector<double>& keytimes) {
  keytimes.assign(set.key_phases.size(), 0);
  // Steps between keytimes are blended, and each is held to the range of the set:
  // the sums are the blended keytimes and stay in order whatever the weights are.
  for (std::size_t k = 1; k < keytimes.size(); ++k) {
    double step = 0;
    double least = INFINITY;
    double most = 0;
    for (int i = 0; i < set.size(); ++i) {
      const std::vector<double>& times = set.cycles[static_cast<std::size_t>(i)].keytimes;
      const double own = times[k] - times[k - 1];
      step += weights(i) * own;
      least = std::min(least, own);
      most = std::max(most, own);
    }
    keytimes[k] = keytimes[k - 1] + std::clamp(step, least, most);
  }
}

Cycle blend(const MotionSpace& space, const Eigen::VectorXd& weights) {
  const MotionSet& set = space.set;
  assert(weights.size() == set.size() && "one weight for each cycle");
  const Eigen::VectorXd x = space.offsets * weights;
  Cycle cycle;
  blend_keytimes(set, weights, cycle.keytimes);
  cycle.seconds = cycle.keytimes.back();
  blend_rotations(space, x, cycle);
  cycle.root.resize(3, set.phases);
  cycle.root.row(1) =
      (space.mean_height + space.leg_length * x.segment(3 * space.average.cols(), set.phases))
          .transpose();
  const Eigen::Matrix2Xd velocity =
      space.leg_length * x.tail(2 * set.phases).reshaped(2, set.phases);
  integrate(set, velocity, cycle);
  return cycle;
}

}  // namespace promenade::motion
