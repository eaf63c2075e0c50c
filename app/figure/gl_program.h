// An OpenGL program as a value that cleans up after itself.
#pragma once

#include <epoxy/gl.h>

#include <Eigen/Dense>

namespace promenade::app {

class GlProgram {
 public:
  // Throws OutsideError with the driver's words when it does not compile.
  GlProgram(const char* vertex_shader, const char* fragment_shader);
  ~GlProgram();
  GlProgram(const GlProgram&) = delete;
  GlProgram& operator=(const GlProgram&) = delete;

  void use() const;
  void set(const char* name, float value) const;
  void set(const char* name, const Eigen::Vector2f& value) const;
  void set(const char* name, const Eigen::Vector3f& value) const;
  void set(const char* name, const Eigen::Vector4f& value) const;

 private:
  GLint place(const char* name) const { return glGetUniformLocation(id_, name); }
  GLuint id_ = 0;
};

}  // namespace promenade::app
