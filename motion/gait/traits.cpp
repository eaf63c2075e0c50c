#include "motion/gait/traits.h"

#include <algorithm>
#include <cmath>

#include "motion/gait/tempo.h"

namespace promenade::motion::gait {

void crouched(GaitStyle& style, double amount) {
  style.knees.strike += 18 * amount;
  style.knees.loading += 18 * amount;
  style.knees.mid += 26 * amount;
  style.knees.release += 20 * amount;
  style.knees.toe_off += 14 * amount;
  style.feet.strike_pitch -= 9 * amount;
  style.feet.push_off_pitch -= 5 * amount;
  style.pelvis.tilt += 9 * amount;
  style.trunk.lean += 16 * amount;
  style.head.neck += 20 * amount;
  style.character.openness -= 0.5 * amount;
}

void stooped(GaitStyle& style, double amount) {
  style.trunk.lean += 20 * amount;
  style.trunk.slump += 0.12 * amount;
  style.head.neck += 22 * amount;
  style.head.pitch += 6 * amount;
  style.arms.forward += 10 * amount;
  style.character.openness -= 0.3 * amount;
  style.character.youth -= 0.4 * amount;
}

void chest_out(GaitStyle& style, double amount) {
  style.trunk.lean -= 10 * amount;
  style.head.neck -= 10 * amount;
  style.head.pitch -= 6 * amount;
  style.arms.forward -= 12 * amount;
  style.character.openness += 0.4 * amount;
  style.character.steadiness += 0.2 * amount;
}

void head_down(GaitStyle& style, double amount) {
  style.head.pitch += 26 * amount;
  style.head.neck += 16 * amount;
  style.character.openness -= 0.2 * amount;
}

void shoulders_up(GaitStyle& style, double amount) {
  style.arms.raise += 14 * amount;
  style.arms.forward += 6 * amount;
  style.character.tension += 0.4 * amount;
}

void leaning_forward(GaitStyle& style, double amount) {
  style.trunk.lean += 12 * amount;
  style.head.neck += 8 * amount;
}

void wide_stance(GaitStyle& style, double amount) {
  style.feet.half_width += 0.08 * amount;
  style.feet.toe_out += 8 * amount;
  style.feet.circumduction += 0.015 * amount;
  style.knees.outward += 13 * amount;
  style.pelvis.sway += 0.02 * amount;
  style.trunk.sway += 2 * amount;
  style.character.openness += 0.4 * amount;
  style.character.weight += 0.3 * amount;
}

void toes_out(GaitStyle& style, double amount) { style.feet.toe_out += 16 * amount; }

void high_steps(GaitStyle& style, double amount) {
  style.feet.lift += 0.06 * amount;
  style.feet.clearance += 0.05 * amount;
  style.feet.lift_peak += 0.08 * amount;
  style.character.naturalness -= 0.2 * amount;
}

void dragging(GaitStyle& style, double amount) {
  style.feet.lift -= 0.026 * amount;
  style.feet.clearance -= 0.013 * amount;
  style.feet.strike_pitch = std::max(4.0, style.feet.strike_pitch - 9 * amount);
  style.character.arousal -= 0.2 * amount;
  style.character.weight += 0.3 * amount;
}

void soft_knees(GaitStyle& style, double amount) {
  style.knees.strike += 8 * amount;
  style.knees.loading += 7 * amount;
  style.knees.mid += 10 * amount;
  style.knees.release += 6 * amount;
}

void on_toes(GaitStyle& style, double amount) {
  style.timing.foot_flat = 0.06;
  style.timing.heel_off -= 0.22 * amount;
  style.feet.strike_pitch = std::max(3.0, style.feet.strike_pitch - 16 * amount);
  style.feet.push_off_haste -= 1.2 * amount;
  style.feet.swing_pitch -= 12 * amount;
  style.character.weight -= 0.6 * amount;
  style.character.naturalness -= 0.2 * amount;
}

void long_steps(GaitStyle& style, double amount) {
  style.timing.cadence *= std::exp(-0.12 * amount);
  style.character.openness += 0.2 * amount;
}

void fast(GaitStyle& style, double amount) { style = at_tempo(style, std::exp(0.3 * amount)); }

void bouncing(GaitStyle& style, double amount) {
  style.timing.heel_off -= 0.09 * amount;
  style.pelvis.bounce += 0.015 * amount;
  style.knees.loading += 11 * amount;
  style.character.valence += 0.2 * amount;
  style.character.youth += 0.3 * amount;
  style.character.weight -= 0.3 * amount;
}

void swaying(GaitStyle& style, double amount) {
  style.pelvis.sway += 0.014 * amount;
  style.trunk.sway += 5 * amount;
  style.head.sway += 4 * amount;
  style.character.steadiness -= 0.4 * amount;
}

void rolling_hips(GaitStyle& style, double amount) {
  style.pelvis.list += 5 * amount;
  style.pelvis.rotation += 6 * amount;
  style.trunk.rotation += 3 * amount;
}

void stiff(GaitStyle& style, double amount) {
  style.crispness += 1.1 * amount;
  style.pelvis.rotation *= 1 - 0.6 * amount;
  style.pelvis.list *= 1 - 0.5 * amount;
  style.trunk.rotation *= 1 - 0.6 * amount;
  style.character.tension += 0.6 * amount;
  style.character.naturalness -= 0.4 * amount;
}

void swinging(GaitStyle& style, double amount) {
  style.arms.swing += 16 * amount;
  style.arms.elbow_swing += 8 * amount;
  style.trunk.rotation += 3 * amount;
  style.character.arousal += 0.2 * amount;
}

void still_arms(GaitStyle& style, double amount) {
  style.arms.swing *= 1 - amount;
  style.arms.elbow_swing *= 1 - amount;
  style.arms.wrist_swing *= 1 - amount;
}

void bent_elbows(GaitStyle& style, double amount) { style.arms.elbow += 50 * amount; }

void arms_out(GaitStyle& style, double amount) {
  style.arms.outward += 22 * amount;
  style.character.openness += 0.2 * amount;
}

void elbows_out(GaitStyle& style, double amount) {
  style.arms.outward += 18 * amount;
  style.arms.twist += 10 * amount;
  style.character.openness += 0.2 * amount;
}

void arms_forward(GaitStyle& style, double amount) {
  style.arms.centre += 26 * amount;
  style.arms.forward += 5 * amount;
}

}  // namespace promenade::motion::gait
