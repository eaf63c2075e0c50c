#include "motion/gait/feet.h"

#include <algorithm>
#include <cmath>

#include "motion/gait/curve.h"

namespace promenade::motion::gait {
namespace {

using Eigen::AngleAxisd;
using Eigen::Quaterniond;
using Eigen::Vector3d;

double strike_slope(const GaitStyle& style) {  // degrees per stride
  return -1.3 * style.feet.strike_pitch / style.timing.foot_flat;
}

double push_off_slope(const GaitStyle& style) {  // degrees per stride
  return -style.feet.push_off_haste * style.feet.push_off_pitch /
         (style.timing.stance - style.timing.heel_off);
}

double swing_span(const GaitStyle& style) { return 1 - style.timing.stance; }

// After toe off the heel still rises a little, before strike the toes are let down.
double swing_pitch(const GaitStyle& style, double share) {
  const double span = swing_span(style);
  const double start = style.timing.stance;
  const double up = 0.10 * span;
  const double down = 0.12 * span;
  const double lowest = -style.feet.push_off_pitch + 0.36 * up * push_off_slope(style);
  const double highest = style.feet.strike_pitch - 0.36 * down * strike_slope(style);
  const double middle = style.feet.swing_pitch + 0.42 * lowest * 0.35;
  const double climb = 1.1 * (highest - lowest) / (span - up - down);
  return through({{start, -style.feet.push_off_pitch, push_off_slope(style)},
                  {start + up, lowest, 0},
                  {start + 0.52 * span, middle, climb},
                  {1 - down, highest, 0},
                  {1, style.feet.strike_pitch, strike_slope(style)}},
                 share);
}

Quaterniond foot_turn(const GaitStyle& style, Side side, double pitch) {
  return turned(sign_of(side) * style.feet.toe_out, -pitch, 0);
}

// Ankle while the foot stands on the spot of its footfall, which lies below the
// ankle of the flat foot.
Vector3d standing_ankle(const GaitStyle& style, Side side, const Vector3d& spot, double pitch) {
  const Vector3d& pivot = pitch > 0 ? heel_point : toe_joint;
  const Vector3d flat = spot + Vector3d(0, ankle_height, 0);
  return flat + foot_turn(style, side, 0) * pivot - foot_turn(style, side, pitch) * pivot;
}

Vector3d ball_of(const GaitStyle& style, Side side, const Vector3d& ankle, double pitch) {
  return ankle + foot_turn(style, side, pitch) * toe_joint;
}

Vector3d footfall(const GaitStyle& style, Side side, double count) {
  const double step = 0.5 * stride_length(style);
  return {sign_of(side) * style.feet.half_width + style.feet.line_shift, 0,
          stride_length(style) * (count + strike_of(style, side)) + style.feet.reach * step};
}

// Velocity of the toe joint, metres per stride, when the heel strikes: the foot
// already turns about its heel.
Vector3d ball_velocity_at_strike(const GaitStyle& style, Side side) {
  const Vector3d arm = foot_turn(style, side, style.feet.strike_pitch) * (toe_joint - heel_point);
  const Vector3d axis = foot_turn(style, side, 0) * Vector3d::UnitX();
  return -strike_slope(style) * degree * axis.cross(arm);
}

// Height of the toe joint in swing: up behind the body, down to pass the other
// foot, up again with the toes, and down with the velocity of the next contact.
double swinging_height(const Feet& feet, double from, double to, double sink, double s) {
  const double pass = feet.lift_peak + 0.27;
  const double crest = to - 0.36 * 0.12 * sink + 0.012;
  const double low = from + feet.clearance;
  return through({{0, from, 0},
                  {feet.lift_peak, from + feet.lift, 0},
                  {pass, low, 0.6 * (crest - low) / (0.88 - pass)},
                  {0.88, crest, 0},
                  {1, to, sink}},
                 s);
}

// The toe joint leaves the ground at rest and arrives with the velocity of the
// next contact.
Vector3d swinging_ball(const GaitStyle& style, Side side, double count, double share) {
  const double span = swing_span(style);
  const double s = (share - style.timing.stance) / span;
  const double push = -style.feet.push_off_pitch;
  const double strike = style.feet.strike_pitch;
  const Vector3d last = standing_ankle(style, side, footfall(style, side, count), push);
  const Vector3d next = standing_ankle(style, side, footfall(style, side, count + 1), strike);
  const Vector3d from = ball_of(style, side, last, push);
  const Vector3d to = ball_of(style, side, next, strike);
  const Vector3d arrival = ball_velocity_at_strike(style, side) * span;
  const double ahead = through({{0, 0, 0}, {0.5, 0.53, 1.65}, {0.87, 0.972, 0.52}, {1, 1, 0}}, s);
  Vector3d ball = from + ahead * (to - from) + s * s * (s - 1) * arrival;
  ball.y() = swinging_height(style.feet, from.y(), to.y(), arrival.y(), s);
  ball.x() += sign_of(side) * style.feet.circumduction * 16 * s * s * (1 - s) * (1 - s);
  return ball;
}

double toes_up(const GaitStyle& style, double share) {
  const double push = style.feet.push_off_pitch;
  if (share <= style.timing.stance) return std::max(0.0, -foot_pitch(style, share));
  const double span = swing_span(style);
  return through({{style.timing.stance, push, -push_off_slope(style)},
                  {style.timing.stance + 0.10 * span,
                   push - 0.2 * 0.1 * span * push_off_slope(style), -0.5 * push / span},
                  {style.timing.stance + 0.50 * span, 6, 0},
                  {1, 0, 0}},
                 share);
}

}  // namespace

double strike_of(const GaitStyle& style, Side side) {
  return side == Side::right ? 0 : style.timing.left_strike;
}

double own_share(const GaitStyle& style, Side side, double stride) {
  const double since = stride - strike_of(style, side);
  return since - std::floor(since);
}

double foot_pitch(const GaitStyle& style, double share) {
  const Timing& timing = style.timing;
  if (share > timing.stance) return swing_pitch(style, share);
  return through({{0, style.feet.strike_pitch, strike_slope(style)},
                  {timing.foot_flat, 0, 0},
                  {timing.heel_off, 0, 0},
                  {timing.stance, -style.feet.push_off_pitch, push_off_slope(style)}},
                 share);
}

FootPose foot_pose(const GaitStyle& style, Side side, double stride) {
  const double count = std::floor(stride - strike_of(style, side));
  const double share = own_share(style, side, stride);
  const double pitch = foot_pitch(style, share);
  FootPose foot;
  foot.turn = foot_turn(style, side, pitch);
  foot.toes_up = toes_up(style, share);
  foot.ankle = share <= style.timing.stance
                   ? standing_ankle(style, side, footfall(style, side, count), pitch)
                   : Vector3d(swinging_ball(style, side, count, share) - foot.turn * toe_joint);
  return foot;
}

}  // namespace promenade::motion::gait
