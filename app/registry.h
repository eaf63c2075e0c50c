// All interfaces that the program has. A file in app/interfaces/ enters its own
// by a constant of its file: `const InterfaceEntry entry{{.name = "labels", ...}};`
#pragma once

#include "study/interface.h"

namespace promenade::app {

struct InterfaceEntry {
  explicit InterfaceEntry(study::InterfaceType type);
};

const study::InterfaceRegistry& interfaces();

}  // namespace promenade::app
