// Inputs as nobody means them: for tests that nothing breaks, whatever is done.
#pragma once

#include "study/interface.h"

namespace promenade::app::bench {

// What the interface proposes, now and then with a value, a target or a kind that cannot
// be.
study::ControlInput likely_input(const study::InterfaceType& type,
                                 const study::InterfaceState& state, study::Rng& rng);

// Every word that any interface knows, on every kind of thing.
study::ControlInput wild_input(const study::InterfaceType& type, const study::InterfaceState& state,
                               study::Rng& rng);

// One or the other.
study::ControlInput any_input(const study::InterfaceType& type, const study::InterfaceState& state,
                              study::Rng& rng);

}  // namespace promenade::app::bench
