// From a row of the log back to what caused it: what a replay is made of.
#pragma once

#include <optional>

#include "study/session.h"

namespace promenade::study {

// The input that logged this event; nothing for what the system wrote by itself
// ("page", "start", "won") and for what was refused. Ticks log no event: where
// the weights moved by themselves, the samples say when.
std::optional<Input> input_of(const Event& event);

}  // namespace promenade::study
