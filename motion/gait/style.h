// What makes one way of walking: the parameters of the gait model. The defaults
// are a normal walk of an adult of 1.75 m; a style says what it does otherwise.
//
// "Stride" counts from the strike of the right heel (0) to the next one (1).
// "Share" is a share of a step's length or of a foot's own stride, which begins
// when that foot strikes. Angles are degrees.
#pragma once

#include <optional>
#include <string>

#include "motion/style_character.h"

namespace promenade::motion::gait {

inline constexpr double walking_speed = 1.3;  // m/s, the same for every style of set A

struct Timing {
  double speed = walking_speed;  // m/s
  double cadence = 106;          // steps per minute; the step length follows from the speed
  double stance = 0.60;          // share of the stride that a foot is on the ground
  double foot_flat = 0.085;      // share of the stride at which the sole lies flat
  double heel_off = 0.32;        // share of the stride at which the heel begins to rise
  double left_strike = 0.5;      // stride at which the left heel strikes; 0.5 is even
};

struct Feet {
  double half_width = 0.05;     // m, ankle from the line of progression
  double line_shift = 0;        // m, both feet to the left
  double toe_out = 7;           // degrees that the toes point outward
  double reach = 0.45;          // share of a step that the ankle lands ahead of the pelvis
  double strike_pitch = 20;     // degrees that the toes are up at heel strike
  double push_off_pitch = 66;   // degrees that the heel is up at toe off
  double push_off_haste = 2.9;  // speed of the rising heel at toe off over its mean, 0 to 3
  double swing_pitch = 0;       // degrees that the toes are up in mid-swing
  double lift = 0.064;          // m that the ball of the foot is lifted behind the body
  double clearance = 0.032;     // m that it is lifted when it passes the other foot
  double lift_peak = 0.33;      // share of the swing at which it is highest
  double circumduction = 0.01;  // m that the foot swings outward
};

struct Knees {
  double strike = 6;    // degrees of flexion at heel strike
  double loading = 18;  // the same while the weight comes on
  double mid = 5;       // the same in late single support
  double release = 15;  // the same when the other heel strikes
  double toe_off = 40;  // the same at toe off
  double outward = 0;   // degrees that the knees point outward, beyond half the toe-out
};

struct Pelvis {
  double tilt = 9;          // degrees forward, mean
  double tilt_swing = 1.5;  // degrees either way, twice a stride
  double list = 4;          // degrees that it drops on the side of the swing leg
  double list_peak = 0.14;  // share of the stance at which it drops most
  double rotation = 4.5;    // degrees either way, forward with the striking leg
  double sway = 0.02;       // m either way, toward the stance leg
  double sway_peak = 0.30;  // stride at which it is farthest over the right foot
  double surge = 0.002;     // m either way along the path, twice a stride
  double bounce = 0;        // m either way of vertical travel beyond what the knees give
};

struct Trunk {
  double lean = 3;              // degrees that the chest leans forward, mean
  double nod = 1;               // degrees either way of the same, twice a stride
  double nod_peak = 0.08;       // stride at which it leans most
  double side_lean = 0;         // degrees to the left, mean
  double sway = 1.5;            // degrees either way, toward the stance leg
  double sway_peak = 0.28;      // stride at which it leans to the right most
  double rotation = 5;          // degrees either way, against the pelvis
  double rotation_peak = 0.52;  // stride at which the right shoulder is most ahead
  double slump = 0;             // share of the lean that sits in the upper back, beyond half
};

struct Head {
  double neck = 14;         // degrees that the neck leans forward of upright
  double pitch = 2;         // degrees that the face looks down
  double tilt = 0;          // degrees to the left, mean
  double turn = 0;          // degrees to the left, mean
  double nod = 0.8;         // degrees either way, twice a stride
  double sway = 0;          // degrees either way, toward the stance leg
  double sway_peak = 0.35;  // stride at which it tilts to the right most
  double follow = 0.15;     // share of the chest's rotation that it follows
};

struct Arms {
  double swing = 18;        // degrees either way
  double centre = -4;       // degrees forward of hanging, mean
  double lag = 0.03;        // share of a stride behind the opposite leg
  double outward = 6;       // degrees away from the body
  double twist = 22;        // degrees that the elbows turn outward
  double elbow = 22;        // degrees of flexion, mean
  double elbow_swing = 9;   // degrees either way, more in the forward swing
  double elbow_lag = 0.04;  // share of a stride behind the upper arm
  double wrist = 8;         // degrees of flexion
  double wrist_swing = 4;   // degrees either way, behind the elbow
  double raise = 0;         // degrees that the shoulders are drawn up
  double forward = 0;       // degrees that the shoulders are drawn forward
};

struct GaitStyle {
  std::string name;    // unique in its set: "misery-slow"
  std::string style;   // "misery"
  std::string family;  // in set N: "crouching"
  StyleCharacter character;
  Timing timing;
  Feet feet;
  Knees knees;
  Pelvis pelvis;
  Trunk trunk;
  Head head;
  Arms arms;                     // the right arm, and the left one if nothing else is said
  std::optional<Arms> left_arm;  // where the left one differs
  double crispness = 0;          // 0: swings like a cosine; 4: jerks between two ends and holds
};

double stride_seconds(const GaitStyle& style);
double stride_length(const GaitStyle& style);  // m

}  // namespace promenade::motion::gait
