// What styles of walking are put together from: each trait changes a style by an
// amount, 1 being plainly visible, and what the style means along with it.
#pragma once

#include "motion/gait/style.h"

namespace promenade::motion::gait {

// Posture.
void crouched(GaitStyle& style, double amount);
void stooped(GaitStyle& style, double amount);
void chest_out(GaitStyle& style, double amount);
void head_down(GaitStyle& style, double amount);
void shoulders_up(GaitStyle& style, double amount);
void leaning_forward(GaitStyle& style, double amount);  // back when negative

// Legs and hips.
void wide_stance(GaitStyle& style, double amount);  // narrow when negative
void toes_out(GaitStyle& style, double amount);
void high_steps(GaitStyle& style, double amount);
void dragging(GaitStyle& style, double amount);
void soft_knees(GaitStyle& style, double amount);
void on_toes(GaitStyle& style, double amount);
void long_steps(GaitStyle& style, double amount);  // short when negative
void fast(GaitStyle& style, double amount);        // slow when negative
void bouncing(GaitStyle& style, double amount);
void swaying(GaitStyle& style, double amount);
void rolling_hips(GaitStyle& style, double amount);
void stiff(GaitStyle& style, double amount);

// Arms.
void swinging(GaitStyle& style, double amount);
void still_arms(GaitStyle& style, double amount);  // 1: no swing
void bent_elbows(GaitStyle& style, double amount);
void arms_out(GaitStyle& style, double amount);
void elbows_out(GaitStyle& style, double amount);
void arms_forward(GaitStyle& style, double amount);

}  // namespace promenade::motion::gait
