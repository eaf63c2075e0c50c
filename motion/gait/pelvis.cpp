#include "motion/gait/pelvis.h"

#include <algorithm>
#include <cmath>

#include "motion/gait/curve.h"

namespace promenade::motion::gait {
namespace {

using Eigen::Vector3d;

constexpr int samples = 60;        // of one stride
constexpr double straightest = 5;  // degrees: a knee never locks

// Distance of hip and ankle when the knee is bent by so many degrees.
double leg_reach(double knee) {
  return std::sqrt(thigh_length * thigh_length + shank_length * shank_length +
                   2 * thigh_length * shank_length * std::cos(knee * degree));
}

// Flexion that the knee of the bearing leg should have, by its own stride.
double wanted_knee(const GaitStyle& style, double share) {
  const Knees& knees = style.knees;
  const double other = 0.5;
  return through({{-0.06, knees.strike + 4, -50},
                  {0, knees.strike, 0.5 * (knees.loading - knees.strike) / 0.13},
                  {0.13, knees.loading, 0},
                  {0.38, knees.mid, 0},
                  {other, knees.release, 1.2 * (knees.release - knees.mid) / (other - 0.38)},
                  {style.timing.stance, knees.toe_off, 350}},
                 share);
}

// A leg's own stride, -0.25 to 0.75: 0 when its heel strikes.
double since_strike(const GaitStyle& style, Side side, double stride) {
  return own_share(style, side, stride + 0.25) - 0.25;
}

// How much a leg has to say about the height: it takes over around its strike.
double bearing(const GaitStyle& style, Side side, double stride) {
  constexpr double ramp = 0.06;
  const double since = since_strike(style, side, stride);
  const double taken = smooth_step(0.5 * (since / ramp + 1));
  const double given = smooth_step(0.5 * ((since - 0.5) / ramp + 1));
  return taken * (1 - given);
}

// Height of the pelvis at which the leg has this reach.
double height_for(const GaitStyle& style, Side side, double stride, double reach) {
  const FootPose foot = foot_pose(style, side, stride);
  const Vector3d hip = pelvis_path(style, stride) + hip_offset(style, side, stride);
  const double flat = (hip - foot.ankle).cwiseProduct(Vector3d(1, 0, 1)).squaredNorm();
  const double rise = std::sqrt(std::max(0.0, reach * reach - flat));
  return foot.ankle.y() + rise - hip.y();
}

double wanted_height(const GaitStyle& style, double stride) {
  double sum = 0;
  double total = 0;
  for (const Side side : {Side::left, Side::right}) {
    const double weight = bearing(style, side, stride);
    if (weight <= 0) continue;
    const double knee = wanted_knee(style, since_strike(style, side, stride));
    sum += weight * height_for(style, side, stride, leg_reach(knee));
    total += weight;
  }
  return sum / total - style.pelvis.bounce * std::cos(4 * pi * (stride - 0.06));
}

struct Excess {
  double height = 0;  // m
  double stride = 0;
};

// Where the pelvis is too high for one of the legs at worst, and by how much.
Excess worst_excess(const GaitStyle& style, const PelvisHeight& height) {
  Excess worst;
  for (int i = 0; i < 2 * samples; ++i) {
    const double stride = 0.5 * i / samples;
    for (const Side side : {Side::left, Side::right}) {
      const double limit = height_for(style, side, stride, leg_reach(straightest));
      const double excess = height_at(height, stride) - limit;
      if (excess > worst.height) worst = {excess, stride};
    }
  }
  return worst;
}

// Sinks by the excess there and half a stride later, and not at all in between.
void dip(PelvisHeight& height, const Excess& excess) {
  const double half = 0.5 * excess.height;
  height[0] -= half;
  height[3] -= half * std::cos(4 * pi * excess.stride);
  height[4] -= half * std::sin(4 * pi * excess.stride);
}

PelvisHeight smoothed_height(const GaitStyle& style) {
  PelvisHeight height{};
  for (int i = 0; i < samples; ++i) {
    const double stride = static_cast<double>(i) / samples;
    const double wanted = wanted_height(style, stride) / samples;
    height[0] += wanted;
    for (int h = 1; h <= height_harmonics; ++h) {
      const auto k = static_cast<std::size_t>(2 * h);
      height[k - 1] += 2 * wanted * std::cos(2 * pi * h * stride);
      height[k] += 2 * wanted * std::sin(2 * pi * h * stride);
    }
  }
  return height;
}

}  // namespace

PelvisHeight pelvis_height(const GaitStyle& style) {
  PelvisHeight height = smoothed_height(style);
  // A leg that is too short asks for a dip where it is; what is left is little.
  for (int i = 0; i < 4; ++i) dip(height, worst_excess(style, height));
  height[0] -= worst_excess(style, height).height;
  return height;
}

double height_at(const PelvisHeight& height, double stride) {
  double sum = height[0];
  for (int h = 1; h <= height_harmonics; ++h) {
    const auto k = static_cast<std::size_t>(2 * h);
    sum +=
        height[k - 1] * std::cos(2 * pi * h * stride) + height[k] * std::sin(2 * pi * h * stride);
  }
  return sum;
}

Eigen::Quaterniond pelvis_turn(const GaitStyle& style, double stride) {
  const Pelvis& p = style.pelvis;
  const double yaw = p.rotation * wave(stride, 0, style.crispness);
  const double pitch = p.tilt + p.tilt_swing * wave(2 * stride, 0.1);
  const double roll = -p.list * wave(stride, p.list_peak, style.crispness);
  return turned(yaw, pitch, roll);
}

Vector3d pelvis_path(const GaitStyle& style, double stride) {
  const Pelvis& p = style.pelvis;
  const double left = -p.sway * wave(stride, p.sway_peak) + style.feet.line_shift;
  const double surge = p.surge * wave(2 * stride, 0.35);
  return {left, 0, stride_length(style) * stride + surge};
}

Vector3d hip_offset(const GaitStyle& style, Side side, double stride) {
  return pelvis_turn(style, stride) * Vector3d(0.088 * sign_of(side), -0.045, 0);
}

}  // namespace promenade::motion::gait
