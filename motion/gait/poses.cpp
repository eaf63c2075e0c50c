#include "motion/gait/poses.h"

namespace promenade::motion::gait {
namespace {

// Arms that keep a pose instead of swinging along.
void hold(Arms& arms, double centre, double outward, double twist, double elbow) {
  arms.centre = centre;
  arms.outward = outward;
  arms.twist = twist;
  arms.elbow = elbow;
  arms.swing = 3;
  arms.elbow_swing = 2;
}

Arms& left_arm_of(GaitStyle& style) {
  if (!style.left_arm) style.left_arm = style.arms;
  return *style.left_arm;
}

}  // namespace

void limp(GaitStyle& style) {
  style.timing.left_strike = 0.475;
  style.feet.push_off_pitch *= 0.75;
  style.trunk.side_lean -= 7;
  style.trunk.sway += 7;
  style.pelvis.list += 3;
  style.character.steadiness -= 0.5;
  style.character.pace -= 0.2;
}

void with_a_stick(GaitStyle& style) {
  limp(style);
  Arms& free = left_arm_of(style);
  free.centre = 8;
  free.elbow = 62;
  style.arms.centre = 30;
  style.arms.elbow = 44;
}

void with_a_bag(GaitStyle& style) {
  Arms& free = left_arm_of(style);
  free.outward = 30;
  free.elbow = 34;
  hold(style.arms, 0, 5, 20, 4);
  style.arms.raise = -8;
  style.trunk.side_lean = 9;
  style.head.tilt = -6;
}

void with_hands_in_pockets(GaitStyle& style) {
  hold(style.arms, -16, 17, 22, 40);
  style.arms.raise = 5;
  style.arms.forward = 6;
}

void with_crossed_arms(GaitStyle& style) { style.arms.twist = 50; }

void with_arms_ahead(GaitStyle& style) { hold(style.arms, 36, 3, 8, 6); }

void with_hands_up(GaitStyle& style) { hold(style.arms, 16, 62, 4, 104); }

void with_folded_hands(GaitStyle& style) {
  hold(style.arms, 6, 5, 48, 34);
  style.feet.toe_out = -3;
}

void looking_around(GaitStyle& style) {
  style.head.turn = 32;
  style.head.tilt = 10;
  style.head.sway = 5;
}

void like_a_machine(GaitStyle& style) {
  style.feet.half_width = 0.08;
  style.pelvis.tilt = 2;
  style.trunk.lean = 0;
  style.trunk.sway = 4;
  style.head.neck = 2;
  style.head.pitch = 0;
  style.head.follow = 1;
  style.arms.outward = 13;
  style.arms.twist = 0;
  style.arms.elbow = 50;
  style.arms.elbow_swing = 0;
  style.arms.wrist_swing = 0;
  style.arms.swing = 24;
}

void lost_in_thought(GaitStyle& style) {
  style.head.tilt = 12;
  style.head.turn = -12;
  style.arms.centre = -12;
}

}  // namespace promenade::motion::gait
