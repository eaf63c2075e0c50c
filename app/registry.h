// All interfaces that the program has. A file in app/interfaces/ enters its own
// by a constant of its file: `const InterfaceEntry entry{{.name = "labels", ...}};`
#pragma once

#include <memory>

#include "study/interface.h"

namespace promenade::app {

struct InterfaceEntry {
  explicit InterfaceEntry(study::InterfaceType type);
};

const study::InterfaceRegistry& interfaces();

// InterfaceType::start of a state that is made of its context alone.
template <typename State>
std::unique_ptr<study::InterfaceState> start_as(const study::InterfaceContext& context) {
  return std::make_unique<State>(context);
}

}  // namespace promenade::app
