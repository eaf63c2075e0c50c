#include "motion/gait/styles.h"

namespace promenade::motion::gait {
namespace {

GaitStyle named(const char* name) {
  GaitStyle style;
  style.name = name;
  return style;
}

GaitStyle happy() {
  GaitStyle style = named("happy");
  style.timing.cadence = 116;
  style.timing.stance = 0.585;
  style.timing.heel_off = 0.26;
  style.feet.push_off_pitch = 66;
  style.feet.lift = 0.06;
  style.knees.loading = 24;
  style.pelvis.bounce = 0.012;
  style.pelvis.list = 5;
  style.trunk.lean = -4;
  style.trunk.sway = 3;
  style.trunk.rotation = 9;
  style.head.pitch = -5;
  style.head.neck = 8;
  style.head.sway = 4;
  style.arms.swing = 34;
  style.arms.centre = 8;
  style.arms.outward = 14;
  style.arms.elbow = 48;
  style.arms.elbow_swing = 22;
  style.arms.forward = -8;
  return style;
}

GaitStyle sad() {
  GaitStyle style = named("sad");
  style.timing.cadence = 106;
  style.timing.stance = 0.63;
  style.timing.foot_flat = 0.07;
  style.feet.strike_pitch = 10;
  style.feet.push_off_pitch = 48;
  style.feet.lift = 0.02;
  style.knees = {9, 18, 14, 18, 42, 0};
  style.pelvis.tilt = 4;
  style.trunk.lean = 15;
  style.trunk.slump = 0.2;
  style.trunk.rotation = 2.5;
  style.head.neck = 42;
  style.head.pitch = 38;
  style.arms.swing = 6;
  style.arms.centre = 2;
  style.arms.outward = 3;
  style.arms.elbow = 10;
  style.arms.elbow_swing = 3;
  style.arms.forward = 20;
  style.arms.raise = -6;
  return style;
}

GaitStyle proud() {
  GaitStyle style = named("proud");
  style.timing.cadence = 98;
  style.feet.toe_out = 13;
  style.feet.strike_pitch = 24;
  style.feet.lift = 0.05;
  style.knees.loading = 11;
  style.pelvis.tilt = 11;
  style.trunk.lean = -10;
  style.trunk.rotation = 6;
  style.head.neck = -2;
  style.head.pitch = -14;
  style.arms.swing = 20;
  style.arms.centre = -10;
  style.arms.outward = 16;
  style.arms.elbow = 16;
  style.arms.forward = -16;
  style.arms.raise = -2;
  return style;
}

GaitStyle sneaky() {
  GaitStyle style = named("sneaky");
  style.timing.cadence = 100;
  style.timing.stance = 0.61;
  style.timing.foot_flat = 0.12;
  style.feet.strike_pitch = 8;
  style.feet.push_off_pitch = 56;
  style.feet.lift = 0.12;
  style.feet.lift_peak = 0.45;
  style.knees = {38, 52, 48, 50, 66, 2};
  style.pelvis.tilt = 18;
  style.trunk.lean = 32;
  style.head.neck = 42;
  style.head.pitch = 0;
  style.arms.swing = 8;
  style.arms.centre = 18;
  style.arms.outward = 12;
  style.arms.twist = 35;
  style.arms.elbow = 100;
  style.arms.elbow_swing = 8;
  style.arms.wrist = 25;
  style.arms.raise = 8;
  style.arms.forward = 8;
  return style;
}

GaitStyle angry() {
  GaitStyle style = named("angry");
  style.timing.cadence = 122;
  style.feet.half_width = 0.075;
  style.feet.strike_pitch = 14;
  style.feet.lift = 0.06;
  style.knees.loading = 22;
  style.pelvis.rotation = 7;
  style.trunk.lean = 14;
  style.trunk.rotation = 10;
  style.head.neck = 30;
  style.head.pitch = 14;
  style.arms.swing = 30;
  style.arms.centre = 0;
  style.arms.outward = 18;
  style.arms.elbow = 62;
  style.arms.elbow_swing = 16;
  style.arms.raise = 12;
  style.arms.forward = 6;
  style.crispness = 0.8;
  return style;
}

GaitStyle catwalk() {
  GaitStyle style = named("catwalk");
  style.timing.cadence = 106;
  style.feet.half_width = -0.015;
  style.feet.toe_out = 3;
  style.feet.lift = 0.06;
  style.pelvis.list = 10;
  style.pelvis.rotation = 12;
  style.pelvis.sway = 0.035;
  style.pelvis.tilt = 13;
  style.trunk.lean = -5;
  style.trunk.sway = 4;
  style.trunk.rotation = 9;
  style.head.neck = 5;
  style.head.pitch = -4;
  style.arms.swing = 22;
  style.arms.centre = -8;
  style.arms.outward = 10;
  style.arms.elbow = 14;
  style.arms.wrist = -18;
  style.arms.forward = -10;
  return style;
}

GaitStyle old() {
  GaitStyle style = named("old");
  style.timing.cadence = 130;
  style.timing.stance = 0.66;
  style.timing.foot_flat = 0.06;
  style.timing.heel_off = 0.40;
  style.feet.half_width = 0.10;
  style.feet.toe_out = 16;
  style.feet.strike_pitch = 7;
  style.feet.push_off_pitch = 38;
  style.feet.lift = 0.015;
  style.knees = {20, 28, 26, 28, 44, 3};
  style.pelvis.tilt = 2;
  style.pelvis.list = 2;
  style.pelvis.rotation = 2;
  style.pelvis.sway = 0.03;
  style.trunk.lean = 34;
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
  style.timing.cadence = 108;
  style.timing.foot_flat = 0.05;
  style.feet.half_width = 0.085;
  style.feet.toe_out = 0;
  style.feet.strike_pitch = 3;
  style.feet.push_off_pitch = 34;
  style.feet.lift = 0.09;
  style.knees = {7, 9, 8, 10, 40, 0};
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
  style.arms.swing = 26;
  style.arms.centre = 4;
  style.arms.outward = 5;
  style.arms.twist = 0;
  style.arms.elbow = 88;
  style.arms.elbow_swing = 0;
  style.arms.wrist = 0;
  style.arms.wrist_swing = 0;
  style.crispness = 2.5;
  return style;
}

GaitStyle drunk() {
  GaitStyle style = named("drunk");
  style.timing.cadence = 102;
  style.timing.stance = 0.62;
  style.feet.half_width = 0.11;
  style.feet.toe_out = 18;
  style.feet.strike_pitch = 12;
  style.feet.lift = 0.05;
  style.knees = {10, 24, 16, 18, 44, 6};
  style.pelvis.tilt = 4;
  style.pelvis.sway = 0.07;
  style.pelvis.sway_peak = 0.36;
  style.trunk.lean = -8;
  style.trunk.sway = 11;
  style.trunk.sway_peak = 0.44;
  style.head.neck = 16;
  style.head.pitch = 12;
  style.head.tilt = 8;
  style.head.sway = 16;
  style.head.sway_peak = 0.52;
  style.arms.swing = 16;
  style.arms.centre = 8;
  style.arms.outward = 24;
  style.arms.elbow = 30;
  style.arms.lag = 0.14;
  style.arms.left_share = 0.5;
  style.arms.left_elbow = 16;
  return style;
}

}  // namespace

std::vector<GaitStyle> styles_of_set_a() {
  return {named("normal"), happy(),   sad(), proud(), sneaky(),
          angry(),         catwalk(), old(), robot(), drunk()};
}

}  // namespace promenade::motion::gait
