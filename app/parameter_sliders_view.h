// Draws the sliders of app/parameter_sliders.h: one below the other, the blend weights at
// the right, and over them the list of parameters while it is open.
#pragma once

#include <array>

#include "app/panel.h"
#include "app/parameter_sliders.h"

namespace promenade::app {

// An InterfaceType's `draw`.
void draw_sliders(const study::InterfaceState& state, study::InterfacePanel& panel);

// "12°", "0.64 m": where a slider at `value` (0 to 1) stands.
struct ValueText {
  std::array<char, 32> letters{};
  std::size_t size = 0;
  std::string_view view() const { return {letters.data(), size}; }
};
ValueText value_text(const SliderParameter& parameter, double value);

// Parts of it.
void draw_parameter_list(const ParameterSliders& sliders, study::InterfacePanel& panel);
void draw_weights_column(const ParameterSliders& sliders, study::InterfacePanel& panel,
                         const Box& box);

// The text in the language on screen.
std::string_view words_of(const study::InterfacePanel& panel, const Words& words);
// The name of a parameter, on one line; returns where it ends, pixels.
float draw_parameter_name(study::InterfacePanel& panel, const SliderParameter& parameter,
                          const Box& box, const Rgb& colour);

}  // namespace promenade::app
