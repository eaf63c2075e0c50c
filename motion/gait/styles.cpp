#include "motion/gait/styles.h"

namespace promenade::motion::gait {
namespace {

GaitStyle named(const char* name) {
  GaitStyle style;
  style.name = name;
  style.style = name;
  return style;
}

GaitStyle happy() {
  GaitStyle style = named("happy");
  style.character = {0.9, 0.7, 0.2, 0.7, -0.6, 0.2, -0.2, 0.5, 0.1};
  style.timing.cadence = 112;
  style.timing.stance = 0.585;
  style.timing.heel_off = 0.19;
  style.feet.push_off_pitch = 70;
  style.feet.lift = 0.075;
  style.knees = {10, 32, 8, 16, 40, 0};
  style.pelvis.bounce = 0.016;
  style.pelvis.list = 5;
  style.pelvis.rotation = 6;
  style.trunk.lean = -6;
  style.trunk.sway = 3;
  style.trunk.rotation = 9;
  style.head.pitch = -8;
  style.head.neck = 8;
  style.head.sway = 5;
  style.arms.swing = 37;
  style.arms.centre = 6;
  style.arms.outward = 20;
  style.arms.twist = 14;
  style.arms.elbow = 50;
  style.arms.elbow_swing = 22;
  style.arms.forward = -8;
  return style;
}

GaitStyle sad() {
  GaitStyle style = named("sad");
  style.character = {-0.8, -0.7, -0.5, -0.7, 0.5, -0.2, -0.1, -0.4, 0.1};
  style.timing.cadence = 110;
  style.timing.stance = 0.62;
  style.timing.foot_flat = 0.07;
  style.feet.reach = 0.45;
  style.feet.strike_pitch = 11;
  style.feet.push_off_pitch = 60;
  style.feet.lift = 0.04;
  style.feet.clearance = 0.022;
  style.knees = {14, 25, 20, 25, 42, 0};
  style.pelvis.tilt = 4;
  style.trunk.lean = 19;
  style.trunk.slump = 0.2;
  style.trunk.rotation = 2.5;
  style.head.neck = 46;
  style.head.pitch = 44;
  style.arms.swing = 6;
  style.arms.centre = 4;
  style.arms.outward = 3;
  style.arms.elbow = 10;
  style.arms.elbow_swing = 3;
  style.arms.forward = 24;
  style.arms.raise = -6;
  style.trunk.nod = 2;
  return style;
}

GaitStyle proud() {
  GaitStyle style = named("proud");
  style.character = {0.5, 0.3, 0, 0.8, 0.2, 0.7, 0.4, -0.1, -0.3};
  style.timing.cadence = 100;
  style.feet.toe_out = 13;
  style.feet.strike_pitch = 24;
  style.feet.reach = 0.45;
  style.feet.lift = 0.07;
  style.knees.loading = 14;
  style.pelvis.tilt = 12;
  style.trunk.lean = -12;
  style.trunk.rotation = 6;
  style.trunk.sway = 3;
  style.head.neck = -2;
  style.head.pitch = -14;
  style.arms.swing = 20;
  style.arms.centre = -8;
  style.arms.outward = 22;
  style.arms.elbow = 32;
  style.arms.elbow_swing = 6;
  style.arms.twist = 34;
  style.arms.forward = -18;
  style.arms.raise = -2;
  return style;
}

GaitStyle sneaky() {
  GaitStyle style = named("sneaky");
  style.character = {-0.2, 0.2, -0.3, -0.6, -0.7, 0.3, 0.6, 0.1, -0.5};
  style.timing.cadence = 100;
  style.timing.stance = 0.61;
  style.timing.foot_flat = 0.12;
  style.feet.strike_pitch = 9;
  style.feet.push_off_pitch = 60;
  style.feet.lift = 0.13;
  style.feet.lift_peak = 0.45;
  style.feet.clearance = 0.075;
  style.knees = {30, 40, 36, 42, 60, 2};
  style.pelvis.tilt = 18;
  style.trunk.lean = 28;
  style.head.neck = 40;
  style.head.pitch = 0;
  style.arms.swing = 8;
  style.arms.centre = 16;
  style.arms.outward = 14;
  style.arms.twist = 10;
  style.arms.elbow = 100;
  style.arms.elbow_swing = 10;
  style.arms.wrist = 30;
  style.arms.raise = 8;
  style.arms.forward = 8;
  return style;
}

GaitStyle angry() {
  GaitStyle style = named("angry");
  style.character = {-0.7, 0.9, 0.5, 0.6, 0.9, 0.5, 0.9, -0.1, -0.1};
  style.timing.cadence = 120;
  style.feet.half_width = 0.085;
  style.feet.strike_pitch = 15;
  style.feet.lift = 0.11;
  style.knees.loading = 26;
  style.pelvis.rotation = 7;
  style.trunk.lean = 19;
  style.trunk.rotation = 10;
  style.head.neck = 38;
  style.head.pitch = 20;
  style.arms.swing = 32;
  style.arms.centre = -8;
  style.arms.outward = 26;
  style.arms.twist = 16;
  style.arms.elbow = 92;
  style.arms.elbow_swing = 14;
  style.arms.raise = 14;
  style.arms.forward = 6;
  style.crispness = 0.8;
  return style;
}

GaitStyle catwalk() {
  GaitStyle style = named("catwalk");
  style.character = {0.5, 0.3, 0, 0.5, -0.4, 0.4, 0.1, 0.2, -0.8};
  style.timing.cadence = 106;
  style.feet.half_width = -0.015;
  style.feet.toe_out = 3;
  style.feet.lift = 0.075;
  style.pelvis.list = 10;
  style.pelvis.rotation = 12;
  style.pelvis.sway = 0.035;
  style.pelvis.tilt = 13;
  style.trunk.lean = -5;
  style.trunk.sway = 4;
  style.trunk.rotation = 9;
  style.head.neck = 5;
  style.head.pitch = -4;
  style.arms.swing = 24;
  style.arms.centre = -6;
  style.arms.outward = 10;
  style.arms.elbow = 14;
  style.arms.wrist = -18;
  style.arms.forward = -10;
  style.left_arm = style.arms;
  style.left_arm->swing = 4;
  style.left_arm->centre = -18;
  style.left_arm->outward = 42;
  style.left_arm->twist = 62;
  style.left_arm->elbow = 98;
  style.left_arm->elbow_swing = 2;
  style.left_arm->wrist = -10;
  return style;
}

GaitStyle old() {
  GaitStyle style = named("old");
  style.character = {-0.3, -0.5, -0.3, -0.6, 0.3, -0.6, 0.3, -1, 0.2};
  style.timing.cadence = 132;
  style.timing.stance = 0.64;
  style.timing.foot_flat = 0.07;
  style.timing.heel_off = 0.33;
  style.feet.half_width = 0.095;
  style.feet.toe_out = 15;
  style.feet.reach = 0.45;
  style.feet.strike_pitch = 9;
  style.feet.push_off_pitch = 50;
  style.feet.lift = 0.03;
  style.feet.clearance = 0.018;
  style.knees = {20, 28, 26, 28, 44, 3};
  style.pelvis.tilt = 2;
  style.pelvis.list = 2;
  style.pelvis.rotation = 2;
  style.pelvis.sway = 0.03;
  style.trunk.lean = 32;
  style.trunk.slump = 0.1;
  style.trunk.rotation = 2;
  style.trunk.sway = 4;
  style.head.neck = 46;
  style.head.pitch = 10;
  style.arms.swing = 7;
  style.arms.centre = 4;
  style.arms.outward = 12;
  style.arms.elbow = 55;
  style.arms.elbow_swing = 5;
  style.arms.forward = 14;
  return style;
}

GaitStyle robot() {
  GaitStyle style = named("robot");
  style.character = {-0.2, 0, 0, 0.1, 0.5, 0.6, 0.9, -0.1, -1};
  style.timing.cadence = 116;
  style.timing.stance = 0.575;
  style.timing.foot_flat = 0.05;
  style.feet.half_width = 0.085;
  style.feet.toe_out = 0;
  style.feet.strike_pitch = 5;
  style.feet.push_off_pitch = 50;
  style.feet.lift = 0.11;
  style.feet.lift_peak = 0.4;
  style.feet.clearance = 0.08;
  style.knees = {8, 10, 8, 12, 40, 0};
  style.pelvis.tilt = 0;
  style.pelvis.tilt_swing = 0;
  style.pelvis.list = 0;
  style.pelvis.rotation = 0;
  style.pelvis.sway = 0.03;
  style.trunk.lean = 0;
  style.trunk.nod = 0;
  style.trunk.sway = 5;
  style.trunk.rotation = 0;
  style.head.neck = 0;
  style.head.pitch = 0;
  style.head.nod = 0;
  style.head.sway = 5;
  style.arms.swing = 28;
  style.arms.centre = 4;
  style.arms.outward = 6;
  style.arms.twist = 0;
  style.arms.elbow = 88;
  style.arms.elbow_swing = 0;
  style.arms.wrist = 0;
  style.arms.wrist_swing = 0;
  style.crispness = 2.2;
  return style;
}

GaitStyle drunk() {
  GaitStyle style = named("drunk");
  style.character = {0.1, -0.3, -0.4, 0.4, 0.4, -1, -0.6, 0, -0.1};
  style.timing.cadence = 104;
  style.timing.stance = 0.61;
  style.feet.half_width = 0.11;
  style.feet.toe_out = 18;
  style.feet.strike_pitch = 13;
  style.feet.push_off_pitch = 64;
  style.feet.reach = 0.45;
  style.feet.lift = 0.06;
  style.feet.circumduction = 0.03;
  style.knees = {12, 26, 14, 20, 44, 6};
  style.pelvis.tilt = 4;
  style.pelvis.sway = 0.065;
  style.pelvis.sway_peak = 0.36;
  style.trunk.lean = -8;
  style.trunk.sway = 11;
  style.trunk.sway_peak = 0.44;
  style.head.neck = 16;
  style.head.pitch = 12;
  style.head.tilt = 6;
  style.head.sway = 16;
  style.head.sway_peak = 0.52;
  style.arms.swing = 16;
  style.arms.centre = 6;
  style.arms.outward = 26;
  style.arms.elbow = 24;
  style.arms.lag = 0.14;
  style.left_arm = style.arms;
  style.left_arm->swing = 9;
  style.left_arm->elbow = 46;
  return style;
}

}  // namespace

std::vector<GaitStyle> styles_of_set_a() {
  return {named("normal"), happy(),   sad(), proud(), sneaky(),
          angry(),         catwalk(), old(), robot(), drunk()};
}

}  // namespace promenade::motion::gait
