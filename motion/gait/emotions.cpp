#include "motion/gait/emotions.h"

#include <cmath>
#include <string>

#include "motion/gait/curve.h"
#include "motion/gait/tempo.h"

namespace promenade::motion::gait {
namespace {

// What holds for every emotion of this valence and arousal, each -1 to 1: people who
// feel well walk upright and with a bounce, the low slump and hang their heads, the
// aroused take long, quick, heavy strides with bent elbows (Montepare 1987; Crane and
// Gross 2007; Roether 2009; Michalak 2009).
StyleCharacter meant(double valence, double arousal) {
  StyleCharacter meant;
  meant.valence = valence;
  meant.arousal = arousal;
  meant.pace = 0.5 * arousal;
  meant.openness = 0.4 * valence + 0.4 * arousal;
  meant.weight = 0.2 * arousal - 0.5 * valence;
  meant.steadiness = 0.2 * valence + 0.2 * arousal;
  meant.tension = 0.6 * arousal - 0.4 * valence;
  return meant;
}

void feel_in_the_legs(GaitStyle& style, double valence, double arousal) {
  style.timing.speed = 1.2 * std::exp(0.22 * arousal + 0.05 * valence);
  style.timing.cadence = 106 * std::exp(0.11 * arousal + 0.02 * valence);
  style.timing.stance = 0.605 - 0.015 * arousal - 0.005 * valence;
  style.feet.strike_pitch = 17 + 6 * arousal + 2 * valence;
  style.feet.push_off_pitch = 63 + 4 * arousal + 2 * valence;
  style.feet.lift = 0.06 + 0.022 * arousal + 0.008 * valence;
  style.feet.clearance = 0.03 + 0.01 * arousal + 0.003 * valence;
  style.knees.strike = 8 - 3 * valence;
  style.knees.mid = 8 - 4 * valence;
  style.knees.loading = 19 + 3 * arousal;
}

void feel_in_the_body(GaitStyle& style, double valence, double arousal) {
  style.pelvis.tilt = 8 + 3 * valence;
  style.pelvis.rotation = 4.5 + 1.5 * arousal + valence;
  style.trunk.lean = 4 - 7 * valence - arousal;
  style.trunk.slump = -0.08 * valence - 0.06 * arousal;
  style.trunk.rotation = 5.5 + 2.5 * arousal + 2 * valence;
  style.head.pitch = 6 - 10 * valence - 9 * arousal;
  style.head.neck = 17 - 9 * valence - 6 * arousal;
  style.arms.swing = 19 + 12 * arousal + 5 * valence;
  style.arms.elbow = 24 + 20 * arousal + 2 * valence;
  style.arms.elbow_swing = 9 + 7 * arousal + 2 * valence;
  style.arms.outward = 9 + 8 * arousal + 2 * valence;
  style.arms.forward = -9 * valence - 5 * arousal;
}

struct Emotion {
  const char* name;
  double angle;   // on Russell's circle, degrees from pleasure toward arousal
  double radius;  // 0: neutral, 1: felt fully
  void (*own)(GaitStyle&);
};

void excitement(GaitStyle& style) {
  style.character.youth = 0.4;
  style.timing.heel_off = 0.22;
  style.pelvis.bounce = 0.017;
  style.pelvis.list = 6;
  style.knees.loading = 30;
  style.trunk.sway = 3;
  style.head.sway = 4;
  style.arms.swing = 38;
  style.arms.elbow = 58;
  style.arms.elbow_swing = 24;
  style.arms.outward = 20;
  style.trunk.lean = -8;
  style.head.pitch = -10;
  style.head.neck = 4;
}

void pleasure(GaitStyle& style) {
  style.character.youth = 0.2;
  style.pelvis.list = 6;
  style.pelvis.sway = 0.028;
  style.trunk.sway = 5;
  style.head.sway = 7;
  style.arms.swing = 33;
  style.arms.centre = 3;
  style.arms.outward = 15;
  style.arms.elbow = 16;
}

void contentment(GaitStyle& style) {
  style.feet.toe_out = 18;
  style.feet.half_width = 0.07;
  style.pelvis.list = 7;
  style.pelvis.rotation = 6;
  style.trunk.lean = -10;
  style.head.tilt = 7;
  style.head.pitch = -5;
  style.arms.swing = 15;
  style.arms.centre = -12;
  style.arms.outward = 18;
  style.arms.elbow = 24;
  style.arms.lag = 0.06;
  style.pelvis.sway = 0.028;
  style.trunk.sway = 4;
}

void sleepiness(GaitStyle& style) {
  style.character.steadiness = -0.6;
  style.character.tension = -0.9;
  style.feet.half_width = 0.075;
  style.feet.lift = 0.03;
  style.feet.clearance = 0.018;
  style.feet.strike_pitch = 7;
  style.knees.loading = 25;
  style.knees.strike = 15;
  style.knees.mid = 15;
  style.pelvis.sway = 0.04;
  style.trunk.sway = 7;
  style.trunk.sway_peak = 0.36;
  style.trunk.lean = 6;
  style.head.tilt = 15;
  style.head.sway = 7;
  style.head.sway_peak = 0.45;
  style.head.pitch = 44;
  style.head.neck = 36;
  style.arms.swing = 8;
  style.arms.lag = 0.12;
  style.arms.elbow = 14;
  style.arms.forward = 10;
  style.arms.outward = 9;
}

void depression(GaitStyle& style) {
  style.feet.strike_pitch = 9;
  style.feet.lift = 0.04;
  style.pelvis.tilt = 3;
  style.knees.strike = 14;
  style.knees.mid = 17;
  style.knees.loading = 22;
  style.trunk.lean = 22;
  style.trunk.slump = 0.25;
  style.trunk.rotation = 2;
  style.head.neck = 50;
  style.head.pitch = 50;
  style.arms.swing = 5;
  style.arms.centre = 6;
  style.arms.outward = 3;
  style.arms.elbow = 9;
  style.arms.forward = 24;
  style.arms.raise = -6;
}

// Holds on to itself, with the hands before the belly.
void misery(GaitStyle& style) {
  style.character.openness = -0.8;
  style.feet.half_width = 0.035;
  style.trunk.lean = 15;
  style.trunk.slump = 0.12;
  style.trunk.rotation = 2;
  style.head.neck = 36;
  style.head.pitch = 28;
  style.head.tilt = 7;
  style.arms.swing = 3;
  style.arms.centre = 4;
  style.arms.outward = 8;
  style.arms.twist = 52;
  style.arms.elbow = 92;
  style.arms.elbow_swing = 2;
  style.arms.forward = 20;
  style.arms.raise = 7;
}

void distress(GaitStyle& style) {
  style.character.steadiness = -0.3;
  style.character.openness = -0.4;
  style.timing.cadence = 117;
  style.feet.half_width = 0.07;
  style.knees.strike = 14;
  style.knees.mid = 16;
  style.knees.loading = 22;
  style.trunk.lean = 19;
  style.trunk.slump = 0.1;
  style.head.neck = 40;
  style.head.pitch = 8;
  style.head.turn = 9;
  style.arms.swing = 14;
  style.arms.centre = -2;
  style.arms.outward = 22;
  style.arms.twist = 34;
  style.arms.elbow = 96;
  style.arms.raise = 18;
  style.arms.forward = 10;
  style.crispness = 0.6;
  style.feet.strike_pitch = 13;
  style.timing.speed = 1.25;
}

// Wide awake and ready: large and heavy, chest out.
void arousal(GaitStyle& style) {
  style.character.openness = 0.7;
  style.character.weight = 0.5;
  style.timing.cadence = 112;
  style.feet.half_width = 0.075;
  style.feet.toe_out = 11;
  style.trunk.lean = -4;
  style.trunk.sway = 4;
  style.trunk.rotation = 10;
  style.head.neck = 6;
  style.head.pitch = -6;
  style.arms.swing = 34;
  style.arms.outward = 27;
  style.arms.twist = 34;
  style.arms.elbow = 46;
  style.arms.forward = -12;
  style.arms.raise = 6;
  style.crispness = 0.5;
}

constexpr Emotion emotions[] = {
    {"excitement", 45, 1, excitement},    {"pleasure", 0, 1, pleasure},
    {"contentment", -45, 1, contentment}, {"sleepiness", -90, 1, sleepiness},
    {"depression", -135, 1, depression},  {"misery", 180, 1, misery},
    {"distress", 135, 1, distress},       {"arousal", 90, 1, arousal},
    {"neutral", 0, 0, [](GaitStyle&) {}},
};

struct Tempo {
  const char* name;
  double factor;  // of the emotion's own speed
};

constexpr Tempo tempos[] = {{"fast", 1.32}, {"normal", 1}, {"slow", 0.66}};

GaitStyle walk_of(const Emotion& emotion) {
  const double valence = emotion.radius * std::cos(emotion.angle * degree);
  const double arousal = emotion.radius * std::sin(emotion.angle * degree);
  GaitStyle style;
  style.character = meant(valence, arousal);
  feel_in_the_legs(style, valence, arousal);
  feel_in_the_body(style, valence, arousal);
  emotion.own(style);
  style.style = emotion.name;
  return style;
}

}  // namespace

std::vector<GaitStyle> styles_of_set_b() {
  std::vector<GaitStyle> styles;
  for (const Emotion& emotion : emotions) {
    for (const Tempo& tempo : tempos) {
      styles.push_back(at_tempo(walk_of(emotion), tempo.factor));
      styles.back().name = std::string(emotion.name) + "-" + tempo.name;
    }
  }
  return styles;
}

}  // namespace promenade::motion::gait
