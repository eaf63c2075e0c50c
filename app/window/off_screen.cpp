#include "app/window/off_screen.h"

#include <epoxy/gl.h>

#include <string>

#include "motion/problem.h"

namespace promenade::app {
namespace {

GLuint attach(GLenum place, GLenum format, int width, int height) {
  GLuint buffer = 0;
  glGenRenderbuffers(1, &buffer);
  glBindRenderbuffer(GL_RENDERBUFFER, buffer);
  glRenderbufferStorage(GL_RENDERBUFFER, format, width, height);
  glFramebufferRenderbuffer(GL_FRAMEBUFFER, place, GL_RENDERBUFFER, buffer);
  return buffer;
}

void check_size(int width, int height) {
  GLint largest = 0;
  glGetIntegerv(GL_MAX_RENDERBUFFER_SIZE, &largest);
  if (width <= largest && height <= largest) return;
  throw OutsideError("the graphics card draws pictures of at most " + std::to_string(largest) +
                     " pixels on a side; ask for smaller ones");
}

}  // namespace

OffScreen::OffScreen(int width, int height) {
  check_size(width, height);
  glGenFramebuffers(1, &frame_);
  glBindFramebuffer(GL_FRAMEBUFFER, frame_);
  colour_ = attach(GL_COLOR_ATTACHMENT0, GL_RGBA8, width, height);
  depth_ = attach(GL_DEPTH_ATTACHMENT, GL_DEPTH_COMPONENT24, width, height);
}

OffScreen::~OffScreen() {
  glBindFramebuffer(GL_FRAMEBUFFER, 0);
  glDeleteFramebuffers(1, &frame_);
  glDeleteRenderbuffers(1, &colour_);
  glDeleteRenderbuffers(1, &depth_);
}

}  // namespace promenade::app
