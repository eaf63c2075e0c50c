// From a row of the log back to what caused it: what a replay is made of.
#pragma once

#include <optional>

#include "study/session.h"

namespace promenade::study {

// The input that logged this event, also one that was refused; nothing for what the system
// wrote by itself ("page", "start", "won"). Ticks log no event: where the weights moved by
// themselves, the samples say when. Throws InputError when its detail is damaged.
std::optional<Input> input_of(const Event& event);

}  // namespace promenade::study
