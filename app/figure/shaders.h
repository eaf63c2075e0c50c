// The two programs that draw the stage, in GLSL. Only app/figure/renderer.cpp
// uses them.
#pragma once

namespace promenade::app {

extern const char* const part_vertex_shader;
extern const char* const part_fragment_shader;
extern const char* const floor_vertex_shader;
extern const char* const floor_fragment_shader;

}  // namespace promenade::app
