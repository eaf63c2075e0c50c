#include "motion/pose_blender.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "motion/pose_kernel.h"

namespace promenade::motion {
namespace {

using Eigen::Index;
using Eigen::Quaterniond;
using Eigen::VectorXd;

constexpr int block_rows = rows_of_a_block;

constexpr int rounded_up(int size, int step) { return (size + step - 1) / step * step; }

// The rotations of a phase, lanes x 4.
const double* blended_phase(const PoseBank& bank, int phase, PoseBlend& blend) {
  double* const result = blend.phases.col(4 * phase).data();
  if (blend.made(phase)) return result;
  blend.made(phase) = true;
  blend_rotations({.lanes = bank.lanes,
                   .rows = bank.rows,
                   .cycles = bank.size(),
                   .weights = blend.weights.data(),
                   .offsets = bank.offsets.col(phase).data(),
                   .average = bank.average.col(4 * phase).data()},
                  blend.offsets.data(), result);
  return result;
}

// sin(s a)/sin(a) = sum a_n (cos a - 1)^n with a_0 = s and
// a_n = a_(n-1) (s^2 - n^2)/(n (2n + 1)): the weights of slerp without arc functions.
constexpr int slerp_terms = 11;

struct SlerpSeries {
  double a[slerp_terms];
};

SlerpSeries slerp_series(double s) {
  SlerpSeries series{};
  series.a[0] = s;
  for (int n = 1; n < slerp_terms; ++n) {
    series.a[n] = series.a[n - 1] * (s * s - n * n) / (n * (2 * n + 1));
  }
  return series;
}

template <int terms>
void series_slerp(Index lanes, double share, const double* a, const double* b, double* result) {
  const SlerpSeries from = slerp_series(1 - share);
  const SlerpSeries to = slerp_series(share);
  for (Index j = 0; j < lanes; ++j) {
    const double cosine = a[j] * b[j] + a[lanes + j] * b[lanes + j] +
                          a[2 * lanes + j] * b[2 * lanes + j] + a[3 * lanes + j] * b[3 * lanes + j];
    const double y = std::abs(cosine) - 1;
    double p = from.a[terms - 1];
    double q = to.a[terms - 1];
    for (int n = terms - 2; n >= 0; --n) {
      p = p * y + from.a[n];
      q = q * y + to.a[n];
    }
    q = std::copysign(q, cosine);
    for (int c = 0; c < 4; ++c) {
      result[c * lanes + j] = p * a[c * lanes + j] + q * b[c * lanes + j];
    }
  }
}

void exact_slerp(Index lanes, double share, const double* a, const double* b, double* result) {
  for (Index j = 0; j < lanes; ++j) {
    const Quaterniond from(a[3 * lanes + j], a[j], a[lanes + j], a[2 * lanes + j]);
    const Quaterniond to(b[3 * lanes + j], b[j], b[lanes + j], b[2 * lanes + j]);
    const Quaterniond mid = from.slerp(share, to);
    for (int c = 0; c < 4; ++c) result[c * lanes + j] = mid.coeffs()(c);
  }
}

// result = slerp(a, b, share) for each lane.
void slerp(Index lanes, double share, const double* a, const double* b, double* result) {
  using Lanes = Eigen::Map<const Eigen::Array<double, Eigen::Dynamic, 4>>;
  const double least = (Lanes(a, lanes, 4) * Lanes(b, lanes, 4)).rowwise().sum().abs().minCoeff();
  // Each term is less than (1 - cos)/2 of the one before: 1e-14 at these bounds.
  if (least > 0.9925) return series_slerp<6>(lanes, share, a, b, result);
  if (least > 0.9) return series_slerp<slerp_terms>(lanes, share, a, b, result);
  exact_slerp(lanes, share, a, b, result);
}

// Durations of the phases as shares of the cycle, from the blended keytimes.
void time_phases(const PoseBank& bank, PoseBlend& blend) {
  const int phases = bank.set.phases;
  for (int f = 0; f < phases; ++f) {
    blend.times(f) =
        seconds_at(bank.set, blend.timing, static_cast<double>(f) / phases) / blend.timing.seconds;
  }
  blend.times(phases) = 1;
}

// As set_planar_path (motion/canonical.h): the path is the integral of the planar
// velocity; its mean velocity and its mean position over time go.
void integrate_path(const PoseBank& bank, PoseBlend& blend) {
  const int phases = bank.set.phases;
  Eigen::Vector2d travel = Eigen::Vector2d::Zero();
  const auto velocity = [&](int f) -> Eigen::Vector2d {
    return blend.mixed_root.segment<2>(phases + 2 * f);
  };
  for (int f = 0; f < phases; ++f) {
    travel += velocity(f) * (blend.times(f + 1) - blend.times(f));
  }
  Eigen::Vector2d sway = Eigen::Vector2d::Zero();
  Eigen::Vector2d mean = Eigen::Vector2d::Zero();
  for (int f = 0; f < phases; ++f) {
    const double passed = blend.times(f + 1) - blend.times(f);
    blend.root(0, f) = sway.x();
    blend.root(2, f) = sway.y();
    const Eigen::Vector2d next = sway + (velocity(f) - travel) * passed;
    mean += 0.5 * (sway + next) * passed;
    sway = next;
  }
  blend.root.row(0).array() -= mean.x();
  blend.root.row(2).array() -= mean.y();
  blend.timing.velocity = travel / blend.timing.seconds;
}

}  // namespace

PoseBank make_pose_bank(const MotionSpace& space) {
  const MotionSet& set = space.set;
  const int joints = set.skeleton.size();
  const Index n = set.size();
  PoseBank bank;
  bank.set = set;
  for (Cycle& cycle : bank.set.cycles) {
    cycle.rotations.resize(4, 0);
    cycle.root.resize(3, 0);
  }
  bank.lanes = rounded_up(joints, 8);
  bank.rows = rounded_up(3 * bank.lanes, block_rows);
  bank.offsets = Eigen::MatrixXd::Zero(bank.rows * n, set.phases);
  bank.average = Eigen::MatrixXd::Zero(bank.lanes, 4 * set.phases);
  for (int f = 0; f < set.phases; ++f) {
    for (int j = 0; j < joints; ++j) {
      const Index column = static_cast<Index>(f) * joints + j;
      for (int c = 0; c < 4; ++c) bank.average(j, 4 * f + c) = space.average(c, column);
      for (int a = 0; a < 3; ++a) {
        const Index row = a * bank.lanes + j;
        const Index first = row / block_rows * block_rows * n + row % block_rows;
        for (Index i = 0; i < n; ++i) {
          bank.offsets(first + block_rows * i, f) = space.offsets(3 * column + a, i);
        }
      }
    }
    bank.average.col(4 * f + 3).tail(bank.lanes - joints).setOnes();
  }
  bank.root = space.leg_length * space.offsets.bottomRows(3 * set.phases);
  bank.mean_height = space.mean_height;
  return bank;
}

PoseBlend make_pose_blend(const PoseBank& bank) {
  PoseBlend blend;
  blend.offsets.resize(bank.rows);
  blend.phases.resize(bank.lanes, 4 * bank.set.phases);
  blend.made.resize(bank.set.phases);
  blend.rotations.resize(bank.lanes, 4);
  blend.root.resize(3, bank.set.phases);
  blend.times.resize(bank.set.phases + 1);
  blend.mixed_root.resize(3 * bank.set.phases);
  blend.timing.keytimes.reserve(bank.set.key_phases.size());
  set_weights(bank, VectorXd::Constant(bank.size(), 1.0 / bank.size()), blend);
  return blend;
}

void set_weights(const PoseBank& bank, const VectorXd& weights, PoseBlend& blend) {
  assert(weights.size() == bank.size() && "one weight for each cycle");
  blend.weights = weights;
  blend.made.setConstant(false);
  blend_keytimes(bank.set, weights, blend.timing.keytimes);
  blend.timing.seconds = blend.timing.keytimes.back();
  time_phases(bank, blend);
  blend.mixed_root.noalias() = bank.root * weights;
  blend.root.row(1) = (bank.mean_height + blend.mixed_root.head(bank.set.phases)).transpose();
  integrate_path(bank, blend);
}

void pose_at(const PoseBank& bank, PoseBlend& blend, double phase, Pose& pose) {
  const int phases = bank.set.phases;
  const double position = (phase - std::floor(phase)) * phases;
  const int f = std::min(static_cast<int>(position), phases - 1);
  const int g = (f + 1) % phases;
  const double share = position - f;
  const Index lanes = bank.lanes;
  const double* mixed = blend.rotations.data();
  slerp(lanes, share, blended_phase(bank, f, blend), blended_phase(bank, g, blend),
        blend.rotations.data());
  pose.root = (1 - share) * blend.root.col(f) + share * blend.root.col(g);
  pose.rotations.resize(bank.set.skeleton.joints.size());
  for (std::size_t j = 0; j < pose.rotations.size(); ++j) {
    const double* lane = mixed + j;
    pose.rotations[j].coeffs() << lane[0], lane[lanes], lane[2 * lanes], lane[3 * lanes];
  }
}

void blended_cycle(const PoseBank& bank, PoseBlend& blend, Cycle& cycle) {
  const int joints = bank.set.skeleton.size();
  const Index lanes = bank.lanes;
  cycle.keytimes = blend.timing.keytimes;
  cycle.seconds = blend.timing.seconds;
  cycle.velocity = blend.timing.velocity;
  cycle.root = blend.root;
  cycle.rotations.resize(4, static_cast<Index>(bank.set.phases) * joints);
  double* to = cycle.rotations.data();
  for (int f = 0; f < bank.set.phases; ++f) {
    const double* const from = blended_phase(bank, f, blend);
    for (int j = 0; j < joints; ++j) {
      for (int c = 0; c < 4; ++c) *to++ = from[c * lanes + j];
    }
  }
}

void distance_points(const PoseBank& bank, PoseBlend& blend, DistancePoints& points,
                     DistanceTimes times) {
  for (int t = 0; t < distance_samples; ++t) {
    pose_at(bank, blend, distance_phase(bank.set, blend.timing, times, t), blend.pose);
    forward_kinematics(bank.set.skeleton, blend.pose, blend.world);
    points.middleCols<body_joint_count>(t * body_joint_count) =
        body_positions(bank.set.body, blend.world);
  }
}

}  // namespace promenade::motion
