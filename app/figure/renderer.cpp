#include "app/figure/renderer.h"

#include "app/figure/gl_program.h"
#include "app/figure/part_quad.h"
#include "app/figure/shaders.h"

namespace promenade::app {
namespace {

constexpr float near_depth = 2, far_depth = 20;  // metres

// The shader works in linear light with gamma 2, which needs a square root only.
Rgb linear(const Rgb& colour) { return colour.cwiseProduct(colour); }

void set_camera(const GlProgram& program, const View& view, int width, int height) {
  program.use();
  program.set("frame_size", Eigen::Vector2f(static_cast<float>(width), static_cast<float>(height)));
  program.set("centre", view.centre);
  program.set("focal", view.focal);
  program.set("eye", view.eye);
  program.set("right", view.right);
  program.set("up", view.up);
  program.set("ahead", view.ahead);
}

void declare_attributes() {
  constexpr std::array<GLint, 9> floats = {2, 2, 2, 3, 3, 3, 3, 3, 3};
  std::size_t offset = 0;
  for (GLuint k = 0; k < floats.size(); ++k) {
    glEnableVertexAttribArray(k);
    // OpenGL wants the offset as a pointer. NOLINTNEXTLINE(performance-no-int-to-ptr)
    const auto* start = reinterpret_cast<const void*>(offset);
    glVertexAttribPointer(k, floats[k], GL_FLOAT, GL_FALSE, sizeof(PartQuad), start);
    glVertexAttribDivisor(k, 1);
    offset += sizeof(float) * static_cast<std::size_t>(floats[k]);
  }
  static_assert(sizeof(PartQuad) == 24 * sizeof(float), "attributes lie without gaps");
}

void scissor(const Box& box, int height) {
  glEnable(GL_SCISSOR_TEST);
  glScissor(static_cast<GLint>(box.x), height - static_cast<GLint>(box.y + box.height),
            static_cast<GLsizei>(box.width), static_cast<GLsizei>(box.height));
}

GLuint make_shadow_texture() {
  GLuint texture = 0;
  glGenTextures(1, &texture);
  glBindTexture(GL_TEXTURE_2D, texture);
  glTexImage2D(GL_TEXTURE_2D, 0, GL_R8, shadow_size, shadow_size, 0, GL_RED, GL_UNSIGNED_BYTE,
               nullptr);
  for (const int axis : {GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T}) {
    glTexParameteri(GL_TEXTURE_2D, static_cast<GLenum>(axis), GL_CLAMP_TO_EDGE);
  }
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
  return texture;
}

}  // namespace

Eigen::Vector3f key_light() { return Eigen::Vector3f(-0.42f, 0.80f, 0.43f).normalized(); }

Eigen::Vector3f shadow_light() { return Eigen::Vector3f(-0.16f, 0.96f, 0.10f).normalized(); }

struct FigureRenderer::Objects {
  GlProgram part{part_vertex_shader, part_fragment_shader};
  GlProgram floor{floor_vertex_shader, floor_fragment_shader};
  GLuint part_array = 0, empty_array = 0, buffer = 0;
  // One for each ground of a frame: a texture that is still to be drawn from would have to
  // be waited for before it takes the next shadow.
  std::vector<GLuint> shadows;
  std::size_t grounds = 0;   // of this frame
  std::vector<Part> sorted;  // kept, so that a frame allocates nothing
  std::vector<PartQuad> quads;
};

FigureRenderer::FigureRenderer() : gl_(std::make_unique<Objects>()) {
  glGenVertexArrays(1, &gl_->empty_array);
  glGenVertexArrays(1, &gl_->part_array);
  glGenBuffers(1, &gl_->buffer);
  glBindVertexArray(gl_->part_array);
  glBindBuffer(GL_ARRAY_BUFFER, gl_->buffer);
  declare_attributes();
  glBindVertexArray(0);
}

FigureRenderer::~FigureRenderer() {
  glDeleteVertexArrays(1, &gl_->empty_array);
  glDeleteVertexArrays(1, &gl_->part_array);
  glDeleteBuffers(1, &gl_->buffer);
  glDeleteTextures(static_cast<GLsizei>(gl_->shadows.size()), gl_->shadows.data());
}

void FigureRenderer::begin(int width, int height, const Rgb& background) {
  width_ = width;
  height_ = height;
  background_ = background;
  gl_->grounds = 0;
  glViewport(0, 0, width, height);
  glDisable(GL_SCISSOR_TEST);
  glDepthMask(GL_TRUE);
  glClearColor(background.x(), background.y(), background.z(), 1);
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
}

void FigureRenderer::draw_ground(const View& view, const Ground& ground, const Shadow& shadow) {
  set_camera(gl_->floor, view, width_, height_);
  gl_->floor.set("area",
                 Eigen::Vector4f(view.clip.x, view.clip.y, view.clip.width, view.clip.height));
  gl_->floor.set("background", background_);
  gl_->floor.set("tint", ground.ring);
  gl_->floor.set("turn", Eigen::Vector2f(std::cos(ground.yaw), std::sin(ground.yaw)));
  gl_->floor.set("travel", ground.travel);
  gl_->floor.set("stroke", ground.stroke);
  gl_->floor.set("dashes", ground.dashed ? 18.0f : 0.0f);
  gl_->floor.set("shadow_width", shadow_metres);
  glActiveTexture(GL_TEXTURE0);
  if (gl_->grounds == gl_->shadows.size()) gl_->shadows.push_back(make_shadow_texture());
  glBindTexture(GL_TEXTURE_2D, gl_->shadows[gl_->grounds++]);
  glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, shadow_size, shadow_size, GL_RED, GL_FLOAT,
                  shadow.texels().data());
  scissor(view.clip, height_);
  glDisable(GL_DEPTH_TEST);
  glDisable(GL_BLEND);
  glBindVertexArray(gl_->empty_array);
  glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
  glDisable(GL_SCISSOR_TEST);
}

void FigureRenderer::draw_parts(const View& view, const std::vector<Part>& parts,
                                const Rgb& colour) {
  gl_->sorted = parts;
  sort_by_depth(view, gl_->sorted);
  gl_->quads.clear();
  for (const Part& part : gl_->sorted) gl_->quads.push_back(make_quad(view, part, linear(colour)));
  set_camera(gl_->part, view, width_, height_);
  gl_->part.set("key_light", key_light());
  gl_->part.set("near_depth", near_depth);
  gl_->part.set("far_depth", far_depth);
  glEnable(GL_DEPTH_TEST);
  glDepthFunc(GL_LEQUAL);
  glEnable(GL_BLEND);
  glBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  glBindVertexArray(gl_->part_array);
  glBindBuffer(GL_ARRAY_BUFFER, gl_->buffer);
  glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(gl_->quads.size() * sizeof(PartQuad)),
               gl_->quads.data(), GL_STREAM_DRAW);
  scissor(view.clip, height_);
  glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, static_cast<GLsizei>(gl_->quads.size()));
  glDisable(GL_SCISSOR_TEST);
  glDisable(GL_DEPTH_TEST);
  glBindVertexArray(0);
}

void FigureRenderer::fill(const Box& box, const Rgb& colour) {
  scissor(box, height_);
  glClearColor(colour.x(), colour.y(), colour.z(), 1);
  glClear(GL_COLOR_BUFFER_BIT);
  glDisable(GL_SCISSOR_TEST);
}

}  // namespace promenade::app
