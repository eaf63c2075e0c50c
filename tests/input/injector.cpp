#include "tests/input/injector.h"

#include <GLFW/glfw3.h>
#include <X11/Xlib.h>
#include <X11/extensions/XTest.h>
#include <X11/keysym.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cmath>
#include <csignal>
#include <ctime>
#include <memory>
#include <new>

#include "app/window/clock.h"
#include "study/rng.h"

namespace promenade::app::input {
namespace {

// The part of the stage where the pointer goes: nothing there ends a trial, and dragging
// turns the figures.
constexpr int left = 100, top = 150, wide = 600, high = 300;

void sleep_until(std::int64_t t_us) {
  const timespec time{t_us / 1'000'000, t_us % 1'000'000 * 1000};
  clock_nanosleep(CLOCK_MONOTONIC, TIMER_ABSTIME, &time, nullptr);
}
void sleep_ms(std::int64_t ms) { sleep_until(monotonic_us() + 1000 * ms); }

class Hand {
 public:
  explicit Hand(Display* display) : display_(display) {}

  Injected move(int number) {
    // Another place for every one of 180,000 numbers.
    Injected event{.x = left + number % wide, .y = top + number / wide % high};
    XTestFakeMotionEvent(display_, -1, event.x, event.y, CurrentTime);
    return sent(event);
  }
  Injected button() {
    button_down_ = !button_down_;
    XTestFakeButtonEvent(display_, 1, button_down_ ? True : False, CurrentTime);
    return sent({.kind = Injected::Kind::button, .down = button_down_});
  }
  Injected key() {
    key_down_ = !key_down_;
    if (key_down_) key_ = (key_ + 1) % keys;
    XTestFakeKeyEvent(display_, XKeysymToKeycode(display_, XK_F1 + key_), key_down_ ? True : False,
                      CurrentTime);
    return sent({.kind = Injected::Kind::key,
                 .down = key_down_,
                 .code = GLFW_KEY_F1 + static_cast<int>(key_)});
  }
  void point(const Place& place) {
    XTestFakeMotionEvent(display_, -1, place.x, place.y, CurrentTime);
    XFlush(display_);
    sleep_ms(200);
  }
  void click(const Place& place) {
    point(place);
    for (int k = 0; k < 2; ++k) {
      button();
      sleep_ms(200);
    }
  }

 private:
  Injected sent(Injected event) {
    event.t_us = monotonic_us();
    XFlush(display_);
    return event;
  }

  // Nine keys by turns: GLFW takes a second press of one key in the same millisecond for
  // an echo of the first, and no hand does that.
  static constexpr KeySym keys = 9;

  Display* display_;
  KeySym key_ = 0;
  bool button_down_ = false, key_down_ = false;
};

// One in fifty is the button, one in fifty a key: a frame takes one change of them, and a
// slow machine shows few. The rest moves the pointer.
void perform(Hand& hand, const Script& script, std::span<Injected> events) {
  study::Rng rng(1, 1, "injector");
  auto due_us = static_cast<double>(monotonic_us());
  for (int k = 0; k < script.events; ++k) {
    due_us += -std::log(1 - rng.uniform()) * 1e6 / script.per_second;
    sleep_until(static_cast<std::int64_t>(due_us));
    const auto choice = rng.below(50);
    events[static_cast<std::size_t>(k)] = choice == 0   ? hand.button()
                                          : choice == 1 ? hand.key()
                                                        : hand.move(k);
  }
}

bool window_is_there(Display* display) {
  ::Window focus = None;
  int ignored = 0;
  XGetInputFocus(display, &focus, &ignored);
  return focus != None && focus != static_cast<::Window>(PointerRoot) &&
         focus != DefaultRootWindow(display);
}

int inject(const Script& script, std::span<Injected> events) {
  const std::unique_ptr<Display, int (*)(Display*)> display(XOpenDisplay(nullptr), XCloseDisplay);
  if (!display) return 1;
  for (int tries = 0; !window_is_there(display.get()); ++tries) {
    if (tries == 600) return 1;
    sleep_ms(100);
  }
  Hand hand(display.get());
  sleep_ms(5000);  // the session looks at the machine first
  for (const Place& place : script.clicks_first) {
    hand.click(place);
    sleep_ms(800);
  }
  hand.point({left + wide / 2, top + high + 1});
  perform(hand, script, events);
  sleep_ms(5000);  // each frame takes one change of a button or key: let them all be taken
  return 0;
}

}  // namespace

std::span<Injected> shared_events(int count) {
  const std::size_t bytes = static_cast<std::size_t>(count) * sizeof(Injected);
  void* memory = mmap(nullptr, bytes, PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
  if (memory == MAP_FAILED) throw std::bad_alloc();
  return {static_cast<Injected*>(memory), static_cast<std::size_t>(count)};
}

pid_t start_injector(const Script& script, std::span<Injected> events) {
  const pid_t parent = getpid();
  const pid_t child = fork();
  if (child != 0) return child;
  const int code = inject(script, events);
  kill(parent, SIGTERM);
  _exit(code);
}

bool injector_finished(pid_t injector) {
  int status = 0;
  waitpid(injector, &status, 0);
  return WIFEXITED(status) && WEXITSTATUS(status) == 0;
}

}  // namespace promenade::app::input
