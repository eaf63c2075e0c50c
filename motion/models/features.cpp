#include "motion/models/features.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>

#include "motion/angles.h"
#include "motion/canonical.h"
#include "motion/models/centre_of_mass.h"

namespace promenade::motion {
namespace {

using Eigen::Index;
using Eigen::Matrix3Xd;
using Eigen::VectorXd;

enum class Statistic { sigma, mu, value };
enum class Quantity { angle, position, velocity, step, duration };
enum Axis { left = 0, vertical = 1, ahead = 2 };

// A feature, told by what is measured.
struct Feature {
  std::string_view name;
  Statistic statistic;
  Quantity quantity;
  Axis axis = left;
  int from = 0, to = 0;  // of an angle: points of BodyPoints
};

constexpr Feature limb(std::string_view name, Statistic statistic, Axis axis, int from, int to) {
  return {name, statistic, Quantity::angle, axis, from, to};
}

constexpr Feature centre(std::string_view name, Statistic statistic, Quantity quantity, Axis axis) {
  return {name, statistic, quantity, axis, 0, 0};
}

using enum Statistic;
constexpr int hips = Segment::mid_hip;
constexpr int shoulders = Segment::mid_shoulder;
constexpr int top = Segment::head_top;

constexpr std::array<Feature, feature_count> table = {{
    limb("sigma_torso_left-right", sigma, left, hips, shoulders),
    limb("sigma_torso_front-back", sigma, ahead, hips, shoulders),
    limb("sigma_head_left-right", sigma, left, neck, top),
    limb("sigma_head_front-back", sigma, ahead, neck, top),
    centre("sigma_com_left-right", sigma, Quantity::position, left),
    limb("sigma_left-upper-arm_front-back", sigma, ahead, left_shoulder, left_elbow),
    limb("sigma_left-upper-arm_left-right", sigma, left, left_shoulder, left_elbow),
    limb("sigma_right-upper-arm_front-back", sigma, ahead, right_shoulder, right_elbow),
    limb("sigma_right-upper-arm_left-right", sigma, left, right_shoulder, right_elbow),
    limb("sigma_left-forearm_front-back", sigma, ahead, left_elbow, left_wrist),
    limb("sigma_right-forearm_front-back", sigma, ahead, right_elbow, right_wrist),
    limb("sigma_left-thigh_front-back", sigma, ahead, left_hip, left_knee),
    limb("sigma_left-thigh_left-right", sigma, left, left_hip, left_knee),
    limb("sigma_right-thigh_front-back", sigma, ahead, right_hip, right_knee),
    limb("sigma_right-thigh_left-right", sigma, left, right_hip, right_knee),
    limb("sigma_left-shin_front-back", sigma, ahead, left_knee, left_ankle),
    limb("sigma_right-shin_front-back", sigma, ahead, right_knee, right_ankle),
    limb("sigma_left-foot_front-back", sigma, ahead, left_ankle, left_toe),
    limb("sigma_left-foot_left-right", sigma, left, left_ankle, left_toe),
    limb("sigma_right-foot_front-back", sigma, ahead, right_ankle, right_toe),
    limb("sigma_right-foot_left-right", sigma, left, right_ankle, right_toe),
    centre("sigma_com-position_vertical", sigma, Quantity::position, vertical),
    centre("sigma_com-velocity_vertical", sigma, Quantity::velocity, vertical),
    centre("sigma_com-velocity_front-back", sigma, Quantity::velocity, ahead),
    centre("sigma_com-velocity_left-right", sigma, Quantity::velocity, left),
    limb("mu_torso_front-back", mu, ahead, hips, shoulders),
    limb("mu_torso_left-right", mu, left, hips, shoulders),
    limb("mu_head_front-back", mu, ahead, neck, top),
    limb("mu_head_left-right", mu, left, neck, top),
    limb("mu_left-upper-arm_front-back", mu, ahead, left_shoulder, left_elbow),
    limb("mu_left-upper-arm_left-right", mu, left, left_shoulder, left_elbow),
    limb("mu_right-upper-arm_front-back", mu, ahead, right_shoulder, right_elbow),
    limb("mu_right-upper-arm_left-right", mu, left, right_shoulder, right_elbow),
    limb("mu_left-forearm_front-back", mu, ahead, left_elbow, left_wrist),
    limb("mu_right-forearm_front-back", mu, ahead, right_elbow, right_wrist),
    limb("mu_left-thigh_front-back", mu, ahead, left_hip, left_knee),
    limb("mu_left-thigh_left-right", mu, left, left_hip, left_knee),
    limb("mu_right-thigh_front-back", mu, ahead, right_hip, right_knee),
    limb("mu_right-thigh_left-right", mu, left, right_hip, right_knee),
    limb("mu_left-shin_front-back", mu, ahead, left_knee, left_ankle),
    limb("mu_right-shin_front-back", mu, ahead, right_knee, right_ankle),
    limb("mu_left-foot_front-back", mu, ahead, left_ankle, left_toe),
    limb("mu_left-foot_left-right", mu, left, left_ankle, left_toe),
    limb("mu_right-foot_front-back", mu, ahead, right_ankle, right_toe),
    limb("mu_right-foot_left-right", mu, left, right_ankle, right_toe),
    centre("mu_com-velocity_left-right", mu, Quantity::velocity, left),
    centre("mu_com-velocity_front-back", mu, Quantity::velocity, ahead),
    centre("mu_com-position_vertical", mu, Quantity::position, vertical),
    centre("v_step-length_left-right", value, Quantity::step, left),
    centre("v_step-length_front-back", value, Quantity::step, ahead),
    {"v_motion-duration", value, Quantity::duration},
}};

// A cycle, played once: F samples at the phases of the grid.
struct Playback {
  std::vector<BodyPoints> points;
  Matrix3Xd centre;    // 3 x F, metres, of mass
  Matrix3Xd velocity;  // 3 x F, m/s, of it
  VectorXd passed;     // F: share of the cycle's time that a sample stands for
  BodyPoints right_on;
};

BodyPoints points_at(const MotionSet& set, const Cycle& cycle, double phase) {
  const WorldPose world = forward_kinematics(set.skeleton, pose_at(set, cycle, phase));
  return body_points(set.skeleton, set.body, world);
}

Playback play(const MotionSet& set, const Cycle& cycle) {
  const int phases = set.phases;
  Playback played;
  played.centre.resize(3, phases);
  played.velocity.resize(3, phases);
  played.passed.resize(phases);
  for (int f = 0; f < phases; ++f) {
    played.points.push_back(points_at(set, cycle, static_cast<double>(f) / phases));
    played.centre.col(f) = centre_of_mass(played.points.back());
  }
  const VectorXd times = normalised_times(set, cycle);
  const Eigen::Vector3d travel(cycle.velocity.x(), 0, cycle.velocity.y());
  for (int f = 0; f < phases; ++f) {
    const int before = (f + phases - 1) % phases;
    const int after = (f + 1) % phases;
    const double span =
        times(f + 1) - times(f) + (f > 0 ? times(f) - times(before) : 1 - times(before));
    played.passed(f) = span / 2;
    played.velocity.col(f) =
        (played.centre.col(after) - played.centre.col(before)) / (span * cycle.seconds) + travel;
  }
  assert(set.key_phases.size() > 1 && "a cycle has keytimes");
  played.right_on = points_at(set, cycle, set.key_phases[1]);
  return played;
}

// Degrees, without jumps from one phase to the next.
VectorXd angles(const Playback& played, const Feature& feature) {
  constexpr double degrees = 180 / pi;
  const bool upright = feature.from == hips || feature.from == neck;
  VectorXd angle(static_cast<Index>(played.points.size()));
  for (Index f = 0; f < angle.size(); ++f) {
    const BodyPoints& points = played.points[static_cast<std::size_t>(f)];
    const Eigen::Vector3d part = points.col(feature.to) - points.col(feature.from);
    const double along = upright ? part.y() : -part.y();
    angle(f) = degrees * std::atan2(part(feature.axis), along);
    if (f > 0) angle(f) -= 360 * std::round((angle(f) - angle(f - 1)) / 360);
  }
  return angle;
}

double mean_angle(const VectorXd& angle, const VectorXd& passed) {
  const double mean = angle.dot(passed);
  return mean - 360 * std::ceil((mean - 180) / 360);
}

double deviation(const VectorXd& values, const VectorXd& passed) {
  const double mean = values.dot(passed);
  return std::sqrt((values.array() - mean).square().matrix().dot(passed));
}

double measure(const Playback& played, const Cycle& cycle, const Feature& feature) {
  if (feature.quantity == Quantity::duration) return cycle.seconds;
  if (feature.quantity == Quantity::step) {
    const Eigen::Vector3d step = played.right_on.col(right_ankle) - played.right_on.col(left_ankle);
    return feature.axis == ahead ? step.z() : -step.x();
  }
  if (feature.quantity == Quantity::angle) {
    const VectorXd angle = angles(played, feature);
    return feature.statistic == mu ? mean_angle(angle, played.passed)
                                   : deviation(angle, played.passed);
  }
  const bool moves = feature.quantity == Quantity::velocity;
  const VectorXd values = (moves ? played.velocity : played.centre).row(feature.axis).transpose();
  return feature.statistic == mu ? values.dot(played.passed) : deviation(values, played.passed);
}

}  // namespace

std::span<const std::string_view> feature_names() {
  static const auto names = [] {
    std::array<std::string_view, feature_count> result;
    std::transform(table.begin(), table.end(), result.begin(),
                   [](const Feature& feature) { return feature.name; });
    return result;
  }();
  return names;
}

int find_feature(std::string_view name) {
  const auto names = feature_names();
  const auto found = std::find(names.begin(), names.end(), name);
  return found == names.end() ? -1 : static_cast<int>(found - names.begin());
}

VectorXd motion_features(const MotionSet& set, const Cycle& cycle) {
  const Playback played = play(set, cycle);
  VectorXd values(feature_count);
  for (int i = 0; i < feature_count; ++i) {
    values(i) = measure(played, cycle, table[static_cast<std::size_t>(i)]);
  }
  return values;
}

Eigen::MatrixXd motion_features(const MotionSet& set) {
  Eigen::MatrixXd values(feature_count, set.size());
  for (int i = 0; i < set.size(); ++i) {
    values.col(i) = motion_features(set, set.cycles[static_cast<std::size_t>(i)]);
  }
  return values;
}

std::string_view feature_unit(int feature) {
  switch (table[static_cast<std::size_t>(feature)].quantity) {
    case Quantity::angle:
      return "deg";
    case Quantity::velocity:
      return "m/s";
    case Quantity::duration:
      return "s";
    default:
      return "m";
  }
}

}  // namespace promenade::motion
