#include "app/window/clock.h"

#include <chrono>

namespace promenade::app {

std::int64_t monotonic_us() {
  const auto now = std::chrono::steady_clock::now().time_since_epoch();
  return std::chrono::duration_cast<std::chrono::microseconds>(now).count();
}

}  // namespace promenade::app
