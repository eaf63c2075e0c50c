#include "motion/gait/emotions.h"

#include <cmath>
#include <string>

#include "motion/gait/curve.h"
#include "motion/gait/tempo.h"

namespace promenade::motion::gait {
namespace {

// What holds for every emotion of this valence and arousal, each -1 to 1: people who
// feel well walk upright and with a bounce, those who are low slump, the aroused take
// long, quick, heavy strides with bent elbows (Montepare 1987; Crane and Gross 2007;
// Roether 2009; Michalak 2009).
GaitStyle felt(double valence, double arousal) {
  GaitStyle style;
  const double low = std::hypot(valence - 0.7, arousal - 0.7) - std::sqrt(0.98);  // away from joy
  style.character.valence = valence;
  style.character.arousal = arousal;
  style.character.pace = 0.5 * arousal;
  style.character.openness = 0.4 * valence + 0.4 * arousal;
  style.character.weight = 0.2 * arousal - 0.5 * valence;
  style.character.steadiness = 0.2 * valence + 0.2 * arousal;
  style.character.tension = 0.6 * arousal - 0.4 * valence;
  style.timing.speed = 1.2 * std::exp(0.28 * arousal + 0.06 * valence);
  style.timing.cadence = 106 * std::exp(0.13 * arousal + 0.03 * valence);
  style.timing.stance = 0.605 - 0.015 * arousal - 0.005 * valence;
  style.feet.strike_pitch = 18 + 4 * arousal + 2 * valence;
  style.feet.lift = 0.06 + 0.02 * arousal + 0.005 * valence;
  style.feet.clearance = 0.03 + 0.008 * arousal;
  style.trunk.lean = 4 - 6 * valence + 4 * low;
  style.head.pitch = 4 + 12 * low;
  style.head.neck = 14 - 7 * valence + 8 * low;
  style.arms.swing = 18 + 9 * arousal + 4 * valence;
  style.arms.elbow = 24 + 22 * arousal + 3 * valence;
  style.arms.elbow_swing = 9 + 5 * arousal + 2 * valence;
  style.arms.outward = 8 + 6 * arousal + 3 * valence;
  style.arms.forward = -6 * valence + 5 * low;
  style.trunk.rotation = 5 + 2 * arousal + 2 * valence;
  return style;
}

struct Emotion {
  const char* name;
  double angle;   // on Russell's circle, degrees from pleasure toward arousal
  double radius;  // 0: neutral, 1: felt fully
  void (*own)(GaitStyle&);
};

constexpr Emotion emotions[] = {
    {"excitement", 45, 1, [](GaitStyle& style) { style.pelvis.bounce = 0.014; }},
    {"pleasure", 0, 1, [](GaitStyle& style) { style.trunk.sway = 4; }},
    {"contentment", -45, 1, [](GaitStyle& style) { style.pelvis.list = 6; }},
    {"sleepiness", -90, 1, [](GaitStyle& style) { style.head.tilt = 8; }},
    {"depression", -135, 1, [](GaitStyle& style) { style.trunk.slump = 0.2; }},
    {"misery", 180, 1, [](GaitStyle& style) { style.arms.elbow = 60; }},
    {"distress", 135, 1, [](GaitStyle& style) { style.arms.raise = 12; }},
    {"arousal", 90, 1, [](GaitStyle& style) { style.arms.outward = 24; }},
    {"neutral", 0, 0, [](GaitStyle&) {}},
};

struct Tempo {
  const char* name;
  double factor;  // of the emotion's own speed
};

constexpr Tempo tempos[] = {{"fast", 1.3}, {"normal", 1}, {"slow", 0.7}};

GaitStyle walk_of(const Emotion& emotion) {
  GaitStyle style = felt(emotion.radius * std::cos(emotion.angle * degree),
                         emotion.radius * std::sin(emotion.angle * degree));
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
