// The monotonic clock. Only app/window and app/doctor read it; everything else is told the time.
#pragma once

#include <cstdint>

namespace promenade::app {

std::int64_t monotonic_us();

}  // namespace promenade::app
