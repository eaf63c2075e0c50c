#include "app/window/window.h"

#include <epoxy/gl.h>
// epoxy comes first: it stands in for the system's GL header.
#include <GLFW/glfw3.h>

#include <nlohmann/json.hpp>

#include "app/window/clock.h"
#include "motion/problem.h"

namespace promenade::app {
namespace {

void start_glfw() {
  if (glfwInit() == GLFW_TRUE) return;
  throw OutsideError(
      "there is no display to open a window on; log in at a screen, or run it "
      "under xvfb-run");
}

GLFWwindow* open(const WindowOptions& options) {
  glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 3);
  glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 3);
  glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
  glfwWindowHint(GLFW_SCALE_TO_MONITOR, GLFW_TRUE);
  glfwWindowHint(GLFW_SAMPLES, 0);
  GLFWmonitor* monitor = glfwGetPrimaryMonitor();
  const GLFWvidmode* mode = monitor != nullptr ? glfwGetVideoMode(monitor) : nullptr;
  GLFWwindow* window = nullptr;
  if (options.windowed || mode == nullptr) {
    window =
        glfwCreateWindow(options.width, options.height, options.title.c_str(), nullptr, nullptr);
  } else {
    window = glfwCreateWindow(mode->width, mode->height, options.title.c_str(), monitor, nullptr);
  }
  if (window != nullptr) return window;
  throw OutsideError("the window cannot be opened; a display with OpenGL 3.3 is needed");
}

}  // namespace

void require_display() { start_glfw(); }

struct Window::Callbacks {
  static Window& of(GLFWwindow* handle) {
    return *static_cast<Window*>(glfwGetWindowUserPointer(handle));
  }
  static void cursor(GLFWwindow* handle, double x, double y) {
    Window& window = of(handle);
    const double scale = window.pixels_per_unit_;
    window.stamp({.kind = UiEvent::Kind::move, .x = x * scale, .y = y * scale});
  }
  static void button(GLFWwindow* handle, int code, int action, int) {
    of(handle).stamp({.kind = UiEvent::Kind::button, .code = code, .down = action == GLFW_PRESS});
  }
  static void scroll(GLFWwindow* handle, double x, double y) {
    of(handle).stamp({.kind = UiEvent::Kind::wheel, .x = x, .y = y});
  }
  static void key(GLFWwindow* handle, int code, int, int action, int) {
    if (action == GLFW_REPEAT) return;
    of(handle).stamp({.kind = UiEvent::Kind::key, .code = code, .down = action == GLFW_PRESS});
  }
  static void character(GLFWwindow* handle, unsigned int code) {
    of(handle).stamp({.kind = UiEvent::Kind::character, .code = static_cast<int>(code)});
  }
  static void focus(GLFWwindow* handle, int gained) {
    of(handle).stamp({.kind = UiEvent::Kind::focus, .down = gained == GLFW_TRUE});
  }
  static void size(GLFWwindow* handle, int, int) { of(handle).measure(); }
};

Window::Window(const WindowOptions& options, InputQueue& queue) : queue_(queue) {
  start_glfw();
  handle_ = open(options);
  glfwSetWindowUserPointer(handle_, this);
  glfwMakeContextCurrent(handle_);
  GLFWmonitor* monitor = glfwGetPrimaryMonitor();
  const GLFWvidmode* mode = monitor != nullptr ? glfwGetVideoMode(monitor) : nullptr;
  refresh_hz_ = mode != nullptr ? mode->refreshRate : 0;
  // Without a known rate a swap does not wait; the frame loop paces itself.
  glfwSwapInterval(refresh_hz_ > 0 ? 1 : 0);
  measure();
  glfwSetCursorPosCallback(handle_, Callbacks::cursor);
  glfwSetMouseButtonCallback(handle_, Callbacks::button);
  glfwSetScrollCallback(handle_, Callbacks::scroll);
  glfwSetKeyCallback(handle_, Callbacks::key);
  glfwSetCharCallback(handle_, Callbacks::character);
  glfwSetWindowFocusCallback(handle_, Callbacks::focus);
  glfwSetFramebufferSizeCallback(handle_, Callbacks::size);
  last_poll_us_ = monotonic_us();
}

Window::~Window() {
  glfwDestroyWindow(handle_);
  glfwTerminate();
}

void Window::measure() {
  glfwGetFramebufferSize(handle_, &width_, &height_);
  int units = 0;
  glfwGetWindowSize(handle_, &units, nullptr);
  pixels_per_unit_ = units > 0 ? static_cast<double>(width_) / units : 1;
  glfwGetWindowContentScale(handle_, &content_scale_, nullptr);
}

void Window::stamp(UiEvent event) {
  event.t_us = monotonic_us();
  event.uncertainty_us = event.t_us - last_poll_us_;
  queue_.push(event);
}

void Window::poll() {
  glfwPollEvents();
  last_poll_us_ = monotonic_us();
}

void Window::wait_events(double seconds) {
  glfwWaitEventsTimeout(seconds);
  last_poll_us_ = monotonic_us();
}

void Window::swap() { glfwSwapBuffers(handle_); }

bool Window::closing() const { return glfwWindowShouldClose(handle_) == GLFW_TRUE; }

void Window::close() { glfwSetWindowShouldClose(handle_, GLFW_TRUE); }

std::string Window::description() const {
  const auto words = [](GLenum name) {
    const auto* text = reinterpret_cast<const char*>(glGetString(name));
    return std::string(text != nullptr ? text : "");
  };
  return nlohmann::json{{"width", width_},
                        {"height", height_},
                        {"refresh_hz", refresh_hz_},
                        {"content_scale", content_scale_},
                        {"renderer", words(GL_RENDERER)},
                        {"opengl", words(GL_VERSION)}}
      .dump();
}

}  // namespace promenade::app
