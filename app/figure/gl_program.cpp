#include "app/figure/gl_program.h"

#include <array>
#include <string>

#include "motion/problem.h"

namespace promenade::app {
namespace {

[[noreturn]] void refuse(const char* words) {
  throw OutsideError(
      "the graphics driver cannot draw the figures; update it, or set "
      "LIBGL_ALWAYS_SOFTWARE=1 (it says: " +
      std::string(words) + ")");
}

GLuint compile(GLenum kind, const char* text) {
  const GLuint shader = glCreateShader(kind);
  glShaderSource(shader, 1, &text, nullptr);
  glCompileShader(shader);
  GLint good = 0;
  glGetShaderiv(shader, GL_COMPILE_STATUS, &good);
  if (good == GL_TRUE) return shader;
  std::array<char, 1000> words{};
  glGetShaderInfoLog(shader, static_cast<GLsizei>(words.size()), nullptr, words.data());
  refuse(words.data());
}

}  // namespace

GlProgram::GlProgram(const char* vertex_shader, const char* fragment_shader) {
  id_ = glCreateProgram();
  const GLuint vertex = compile(GL_VERTEX_SHADER, vertex_shader);
  const GLuint fragment = compile(GL_FRAGMENT_SHADER, fragment_shader);
  glAttachShader(id_, vertex);
  glAttachShader(id_, fragment);
  glLinkProgram(id_);
  glDeleteShader(vertex);
  glDeleteShader(fragment);
  GLint good = 0;
  glGetProgramiv(id_, GL_LINK_STATUS, &good);
  if (good == GL_TRUE) return;
  std::array<char, 1000> words{};
  glGetProgramInfoLog(id_, static_cast<GLsizei>(words.size()), nullptr, words.data());
  refuse(words.data());
}

GlProgram::~GlProgram() { glDeleteProgram(id_); }

void GlProgram::use() const { glUseProgram(id_); }

void GlProgram::set(const char* name, float value) const { glUniform1f(place(name), value); }

void GlProgram::set(const char* name, const Eigen::Vector2f& value) const {
  glUniform2fv(place(name), 1, value.data());
}

void GlProgram::set(const char* name, const Eigen::Vector3f& value) const {
  glUniform3fv(place(name), 1, value.data());
}

void GlProgram::set(const char* name, const Eigen::Vector4f& value) const {
  glUniform4fv(place(name), 1, value.data());
}

}  // namespace promenade::app
