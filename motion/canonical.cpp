#include "motion/canonical.h"

#include <cassert>

namespace promenade::motion {

Eigen::VectorXd normalised_times(const MotionSet& set, const Cycle& cycle) {
  Eigen::VectorXd times(set.phases + 1);
  for (int f = 0; f < set.phases; ++f) {
    times(f) = seconds_at(set, cycle, static_cast<double>(f) / set.phases) / cycle.seconds;
  }
  times(set.phases) = 1;
  return times;
}

void set_planar_path(const MotionSet& set, const Eigen::Matrix2Xd& path, Cycle& cycle) {
  assert(path.cols() == set.phases + 1 && "the path includes the closing phase");
  const Eigen::VectorXd times = normalised_times(set, cycle);
  const Eigen::Vector2d travel = path.col(set.phases) - path.col(0);
  Eigen::Matrix2Xd sway = path - travel * times.transpose();
  Eigen::Vector2d mean = Eigen::Vector2d::Zero();
  for (int f = 0; f < set.phases; ++f) {
    mean += 0.5 * (sway.col(f) + sway.col(f + 1)) * (times(f + 1) - times(f));
  }
  sway.colwise() -= mean;
  cycle.velocity = travel / cycle.seconds;
  cycle.root.conservativeResize(3, set.phases);
  cycle.root.row(0) = sway.row(0).head(set.phases);
  cycle.root.row(2) = sway.row(1).head(set.phases);
}

Cycle canonical_cycle(const MotionSet& set, const std::vector<double>& keytimes,
                      const std::function<Pose(double seconds)>& pose) {
  const int joints = set.skeleton.size();
  Cycle cycle;
  cycle.keytimes = keytimes;
  cycle.seconds = keytimes.back();
  cycle.rotations.resize(4, set.phases * joints);
  cycle.root.resize(3, set.phases);
  Eigen::Matrix2Xd path(2, set.phases + 1);
  for (int f = 0; f <= set.phases; ++f) {
    const double seconds = f < set.phases
                               ? seconds_at(set, cycle, static_cast<double>(f) / set.phases)
                               : cycle.seconds;
    const Pose now = pose(seconds);
    path.col(f) << now.root.x(), now.root.z();
    if (f == set.phases) break;
    cycle.root(1, f) = now.root.y();
    for (int j = 0; j < joints; ++j) {
      cycle.rotations.col(f * joints + j) = now.rotations[static_cast<std::size_t>(j)].coeffs();
    }
  }
  set_planar_path(set, path, cycle);
  return cycle;
}

}  // namespace promenade::motion
