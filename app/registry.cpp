#include "app/registry.h"

namespace promenade::app {
namespace {

study::InterfaceRegistry& registry() {
  static study::InterfaceRegistry only;
  return only;
}

}  // namespace

InterfaceEntry::InterfaceEntry(study::InterfaceType type) { registry().add(std::move(type)); }

const study::InterfaceRegistry& interfaces() { return registry(); }

}  // namespace promenade::app
