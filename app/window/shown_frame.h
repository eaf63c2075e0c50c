// A frame that has been put on screen, and how long it took.
#pragma once

#include <cstdint>

namespace promenade::app {

struct ShownFrame {
  std::int64_t shown_us = 0;     // on the monotonic clock
  std::int64_t interval_us = 0;  // since the frame before was shown; 0: it is the first
  std::int64_t work_us = 0;      // from its first drawing until it was shown
  std::int64_t late_us = 0;      // how much later than due; 0: less than half a frame
};

}  // namespace promenade::app
