#include "app/window/window.h"

#include <epoxy/gl.h>
// epoxy comes first: it stands in for the system's GL header.
#include <GLFW/glfw3.h>

#include <nlohmann/json.hpp>
#include <vector>

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

// GLFW is stopped with the last window.
int& windows() {
  static int count = 0;
  return count;
}

std::vector<GLFWmonitor*> displays() {
  int count = 0;
  GLFWmonitor** first = glfwGetMonitors(&count);
  return {first, first + count};
}

// "1 (DP-1, 1920 x 1080), 2 (HDMI-1, 1280 x 720)"
std::string list_of(const std::vector<GLFWmonitor*>& monitors) {
  std::string list;
  for (std::size_t i = 0; i < monitors.size(); ++i) {
    const GLFWvidmode* mode = glfwGetVideoMode(monitors[i]);
    list += (i > 0 ? ", " : "") + std::to_string(i + 1) + " (" + glfwGetMonitorName(monitors[i]);
    if (mode != nullptr) {
      list += ", " + std::to_string(mode->width) + " x " + std::to_string(mode->height);
    }
    list += ")";
  }
  return list.empty() ? "none" : list;
}

// Null: there is none at all.
GLFWmonitor* display(int screen) {
  if (screen == 0) return glfwGetPrimaryMonitor();
  const std::vector<GLFWmonitor*> monitors = displays();
  if (screen <= static_cast<int>(monitors.size())) {
    return monitors[static_cast<std::size_t>(screen) - 1];
  }
  throw OutsideError(
      "display " + std::to_string(screen) + " is not there; the displays are " + list_of(monitors) +
      "; name one of these (\"screen\" under [display], or --screen), or use a window");
}

GLFWwindow* open(const WindowOptions& options) {
  glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 3);
  glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 3);
  glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
  glfwWindowHint(GLFW_SCALE_TO_MONITOR, GLFW_TRUE);
  glfwWindowHint(GLFW_SAMPLES, 0);
  glfwWindowHint(GLFW_VISIBLE, options.hidden ? GLFW_FALSE : GLFW_TRUE);
  glfwWindowHint(GLFW_FOCUSED, options.shows_only ? GLFW_FALSE : GLFW_TRUE);
  glfwWindowHint(GLFW_FOCUS_ON_SHOW, options.shows_only ? GLFW_FALSE : GLFW_TRUE);
  // Two screens are looked at by turns; none goes away with the pointer.
  glfwWindowHint(GLFW_AUTO_ICONIFY, GLFW_FALSE);
  GLFWmonitor* monitor = options.windowed ? nullptr : display(options.screen);
  const GLFWvidmode* mode = monitor != nullptr ? glfwGetVideoMode(monitor) : nullptr;
  GLFWwindow* window = nullptr;
  if (mode == nullptr) {
    window =
        glfwCreateWindow(options.width, options.height, options.title.c_str(), nullptr, nullptr);
  } else {
    window = glfwCreateWindow(mode->width, mode->height, options.title.c_str(), monitor, nullptr);
  }
  if (window != nullptr) return window;
  throw OutsideError("the window cannot be opened; a display with OpenGL 3.3 is needed");
}

}  // namespace

void require_display(int screen) {
  start_glfw();
  display(screen);
}

std::vector<std::string> display_names() {
  start_glfw();
  std::vector<std::string> names;
  for (GLFWmonitor* monitor : displays()) {
    const GLFWvidmode* mode = glfwGetVideoMode(monitor);
    std::string name = std::to_string(names.size() + 1) + ": " + glfwGetMonitorName(monitor);
    if (mode != nullptr) {
      name += ", " + std::to_string(mode->width) + " x " + std::to_string(mode->height);
    }
    names.push_back(name);
  }
  return names;
}

int another_display(int screen) {
  const std::vector<GLFWmonitor*> monitors = displays();
  if (monitors.size() < 2) {
    throw OutsideError("the examples are to walk on a second display, but there is only " +
                       list_of(monitors) +
                       "; connect another one, or set examples = \"panel\" under [display]");
  }
  return screen <= 1 ? 2 : 1;
}

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
  static void drop(GLFWwindow* handle, int count, const char** paths) {
    std::vector<std::string>& dropped = of(handle).dropped_;
    dropped.insert(dropped.end(), paths, paths + count);
  }
  static void size(GLFWwindow* handle, int, int) { of(handle).measure(); }
};

Window::Window(const WindowOptions& options, InputQueue& queue) : queue_(queue) {
  start_glfw();
  handle_ = open(options);
  ++windows();
  glfwSetWindowUserPointer(handle_, this);
  glfwMakeContextCurrent(handle_);
  GLFWmonitor* monitor = options.windowed ? glfwGetPrimaryMonitor() : display(options.screen);
  const GLFWvidmode* mode = monitor != nullptr ? glfwGetVideoMode(monitor) : nullptr;
  refresh_hz_ = mode != nullptr ? mode->refreshRate : 0;
  // Without a known rate a swap does not wait; the frame loop paces itself.
  glfwSwapInterval(refresh_hz_ > 0 && !options.shows_only ? 1 : 0);
  measure();
  last_poll_us_ = monotonic_us();
  glfwSetFramebufferSizeCallback(handle_, Callbacks::size);
  if (options.shows_only) return;
  glfwSetCursorPosCallback(handle_, Callbacks::cursor);
  glfwSetMouseButtonCallback(handle_, Callbacks::button);
  glfwSetScrollCallback(handle_, Callbacks::scroll);
  glfwSetKeyCallback(handle_, Callbacks::key);
  glfwSetCharCallback(handle_, Callbacks::character);
  glfwSetWindowFocusCallback(handle_, Callbacks::focus);
  glfwSetDropCallback(handle_, Callbacks::drop);
}

Window::~Window() {
  glfwDestroyWindow(handle_);
  if (--windows() == 0) glfwTerminate();
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

void Window::note_gap() const {
  if (gaps_us_ != nullptr) gaps_us_->push_back(monotonic_us() - last_poll_us_);
}

void Window::poll() {
  note_gap();
  glfwPollEvents();
  last_poll_us_ = monotonic_us();
}

void Window::wait_events(double seconds) {
  note_gap();
  glfwWaitEventsTimeout(seconds);
  last_poll_us_ = monotonic_us();
}

void Window::use() { glfwMakeContextCurrent(handle_); }

void Window::swap() { glfwSwapBuffers(handle_); }

bool Window::closing() const { return glfwWindowShouldClose(handle_) == GLFW_TRUE; }

void Window::stay() { glfwSetWindowShouldClose(handle_, GLFW_FALSE); }

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
