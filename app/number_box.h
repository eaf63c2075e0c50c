// A whole number to write, or to change by one with a button or an arrow key.
#pragma once

#include <cstdint>

#include "app/text_box.h"

namespace promenade::app {

struct NumberDraft {
  int value = 0;
  Draft draft = {};
};

// Is "less", "type" and "more" `target`. True: the value has changed; it stays between the ends.
bool number_box(const Ui& ui, std::string_view target, const Box& box, NumberDraft& number,
                int least, int most, std::int64_t now_us);

}  // namespace promenade::app
