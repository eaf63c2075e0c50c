// Which arrived event is which injected one. The pointer's places are all different, so
// that an event that was lost does not shift those after it.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "app/window/input_queue.h"

namespace promenade::app::input {

// What was sent to the X server, and when on the monotonic clock: right before it left.
struct Injected {
  enum class Kind : std::int32_t { move, button, key };
  Kind kind = Kind::move;
  std::int32_t x = 0, y = 0;  // of a move: pixels
  bool down = false;          // of a button or a key
  std::int32_t code = 0;      // of a key: GLFW's number
  std::int64_t t_us = 0;
};

struct Matching {
  std::vector<std::int64_t> error_us;        // of each that arrived: its stamp minus the true time
  std::vector<std::int64_t> uncertainty_us;  // that it claims
  std::array<std::int64_t, 3> lost_of_kind{};  // moves, buttons, keys
  std::int64_t foreign = 0;                    // arrived, but nobody sent it, or out of order

  std::int64_t lost() const { return lost_of_kind[0] + lost_of_kind[1] + lost_of_kind[2]; }
  // How many true times lie within [t - uncertainty - slack, t].
  std::int64_t within(std::int64_t slack_us = 0) const;
};

Matching match(const std::vector<Injected>& injected, const std::vector<UiEvent>& arrived);

}  // namespace promenade::app::input
