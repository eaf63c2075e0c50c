#include "app/figure/shaders.h"

namespace promenade::app {

// One quad around each part. `frame_size` is in pixels; y runs down in all pixels
// of the program and up in OpenGL's.
const char* const part_vertex_shader = R"glsl(#version 330 core
layout(location = 0) in vec2 middle;
layout(location = 1) in vec2 along;
layout(location = 2) in vec2 aside;
layout(location = 3) in vec3 row_x;
layout(location = 4) in vec3 row_y;
layout(location = 5) in vec3 row_z;
layout(location = 6) in vec3 local_eye;
layout(location = 7) in vec3 shape;
layout(location = 8) in vec3 colour;
uniform vec2 frame_size, centre;
uniform float focal;
uniform vec3 right, up, ahead;
noperspective out vec3 world_ray;
noperspective out vec3 local_ray;
flat out vec3 eye_at, solid, tint, to_x, to_y, to_z;
void main() {
  vec2 corner = vec2((gl_VertexID & 1) * 2 - 1, (gl_VertexID & 2) - 1);
  vec2 pixel = middle + corner.x * along + corner.y * aside;
  vec2 from_centre = pixel - centre;
  world_ray = focal * ahead + from_centre.x * right - from_centre.y * up;
  local_ray = vec3(dot(row_x, world_ray), dot(row_y, world_ray), dot(row_z, world_ray));
  eye_at = local_eye; solid = shape; tint = colour;
  to_x = row_x; to_y = row_y; to_z = row_z;
  vec2 ndc = 2.0 * pixel / frame_size - 1.0;
  gl_Position = vec4(ndc.x, -ndc.y, 0.0, 1.0);
}
)glsl";

// The ray meets a round cone: spheres of radius r0 at 0 and r1 at (0, length, 0)
// and the cone that touches both. Everything is in the part's own space, in which
// it is not flattened. With q the sine of the cone's slope, the cone is
// rho = (r0 - q y) / sqrt(1 - q^2) between y = r0 q and y = length + r1 q.
const char* const part_fragment_shader = R"glsl(#version 330 core
noperspective in vec3 world_ray;
noperspective in vec3 local_ray;
flat in vec3 eye_at, solid, tint, to_x, to_y, to_z;
uniform vec3 eye, key_light;
uniform float focal, near_depth, far_depth;
out vec4 pixel;

// The quadratic's discriminant is 0 on the outline: over its slope in pixels it is
// the share of the pixel that is covered.
float covered(float h) {
  return clamp(h / max(length(vec2(dFdx(h), dFdy(h))), 1e-12), 0.0, 1.0);
}

bool meet(out float t, out vec3 normal, out float share) {
  float q = (solid.y - solid.z) / solid.x;
  float c2 = 1.0 - q * q;
  float slope = q * local_ray.y, start = solid.y - q * eye_at.y;
  float a = dot(local_ray.xz, local_ray.xz) - slope * slope / c2;
  float b = dot(eye_at.xz, local_ray.xz) + slope * start / c2;
  float h = b * b - a * (dot(eye_at.xz, eye_at.xz) - start * start / c2);

  vec3 from_end = eye_at - vec3(0.0, solid.x, 0.0);
  float a01 = dot(local_ray, local_ray);
  float b0 = dot(eye_at, local_ray), b1 = dot(from_end, local_ray);
  float h0 = b0 * b0 - a01 * (dot(eye_at, eye_at) - solid.y * solid.y);
  float h1 = b1 * b1 - a01 * (dot(from_end, from_end) - solid.z * solid.z);
  float share_cone = covered(h), share0 = covered(h0), share1 = covered(h1);

  if (h > 0.0) {
    t = (-b - sqrt(h)) / a;
    vec3 p = eye_at + t * local_ray;
    if (p.y > solid.y * q && p.y < solid.x + solid.z * q) {
      normal = vec3(p.xz * (c2 / (solid.y - q * p.y)), q).xzy;
      share = share_cone;
      return true;
    }
  }
  if (h0 <= 0.0 && h1 <= 0.0) return false;
  float t0 = h0 > 0.0 ? (-b0 - sqrt(h0)) / a01 : 1e9;
  float t1 = h1 > 0.0 ? (-b1 - sqrt(h1)) / a01 : 1e9;
  bool first = t0 < t1;
  t = first ? t0 : t1;
  normal = (first ? eye_at : from_end) + t * local_ray;
  share = first ? share0 : share1;
  return true;
}

void main() {
  float t, alpha; vec3 local_normal;
  if (!meet(t, local_normal, alpha)) discard;
  vec3 n = normalize(local_normal.x * to_x + local_normal.y * to_y + local_normal.z * to_z);
  vec3 v = -normalize(world_ray);
  float facing = max(dot(n, v), 0.0);
  float depth = t * focal;

  float key = max((dot(n, key_light) + 0.22) / 1.22, 0.0);
  float rise = 0.5 + 0.5 * n.y;
  vec3 light = 1.02 * key * vec3(1.0, 0.955, 0.88) + mix(vec3(0.20, 0.19, 0.185), vec3(0.34, 0.38, 0.44), rise);
  float height = eye.y + t * world_ray.y;
  light *= mix(0.72, 1.0, smoothstep(0.0, 0.35, height));
  float shine = pow(max(dot(n, normalize(key_light + v)), 0.0), 44.0);
  float away = 1.0 - facing;
  float rim = away * away * away * (0.05 + 0.13 * rise);
  vec3 colour = tint * light + shine * 0.10 * vec3(1.0, 0.97, 0.92) + rim * vec3(0.75, 0.85, 1.0);
  pixel = vec4(sqrt(clamp(colour, 0.0, 1.0)), alpha);
  // A faint edge must not hide what is drawn behind it later.
  gl_FragDepth = alpha < 0.5 ? 0.9999 : (depth - near_depth) / (far_depth - near_depth);
}
)glsl";

const char* const floor_vertex_shader = R"glsl(#version 330 core
uniform vec2 frame_size, centre;
uniform float focal;
uniform vec3 right, up, ahead;
uniform vec4 area;
out vec2 at;
noperspective out vec3 world_ray;
void main() {
  at = area.xy + vec2(gl_VertexID & 1, (gl_VertexID >> 1) & 1) * area.zw;
  vec2 from_centre = at - centre;
  world_ray = focal * ahead + from_centre.x * right - from_centre.y * up;
  vec2 ndc = 2.0 * at / frame_size - 1.0;
  gl_Position = vec4(ndc.x, -ndc.y, 0.0, 1.0);
}
)glsl";

// The ground around one figure: it turns with the figure, moves past under its
// feet, and fades into the background before the border of its area.
const char* const floor_fragment_shader = R"glsl(#version 330 core
in vec2 at;
noperspective in vec3 world_ray;
uniform vec3 eye, background, tint;
uniform vec4 area;
uniform vec2 turn, travel;
uniform float focal, dashes, shadow_width, stroke;
uniform sampler2D shadow;
out vec4 pixel;

float line(vec2 q, float spacing, vec2 width) {
  vec2 away = abs(fract(q / spacing - 0.5) - 0.5) * spacing;
  vec2 ink = clamp(1.0 - away / width, 0.0, 1.0);
  return max(ink.x, ink.y);
}

void main() {
  if (world_ray.y > -1e-4) discard;
  float t = -eye.y / world_ray.y;
  vec2 p = eye.xz + t * world_ray.xz;
  float far = length(p);
  float fade = 1.0 - smoothstep(0.45, 1.9, far);
  vec2 edge = min(at - area.xy, area.xy + area.zw - at) / area.z;
  fade *= smoothstep(0.0, 0.22, edge.x) * smoothstep(0.0, 0.06, edge.y);
  vec2 q = vec2(turn.x * p.x - turn.y * p.y, turn.y * p.x + turn.x * p.y) + travel;
  vec2 width = 1.1 * stroke * fwidth(q);
  float grid = max(0.085 * line(q, 0.2, width), 0.17 * line(q, 1.0, 1.4 * width));
  vec3 ground = mix(background, vec3(0.955, 0.95, 0.94), 0.75 * fade);
  ground *= 1.0 - grid * fade;

  float light = texture(shadow, p / shadow_width + 0.5).r;
  light = mix(1.0, light, min(1.0, 2.5 * fade));
  ground *= mix(vec3(0.30, 0.31, 0.36), vec3(1.0), light);

  float ring = abs(far - 0.46) / max(fwidth(far), 1e-5);
  float ink = clamp(0.6 + 1.5 * stroke - ring, 0.0, 1.0);
  if (dashes > 0.0) {
    float around = fract(atan(p.y, p.x) * dashes / 6.2831853);
    ink *= smoothstep(0.0, 0.06, around) * (1.0 - smoothstep(0.58, 0.64, around));
  }
  pixel = vec4(mix(ground, tint, 0.92 * ink), 1.0);
}
)glsl";

}  // namespace promenade::app
