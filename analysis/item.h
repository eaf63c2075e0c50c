// Indices are int here, so that -1 can say "none"; containers count otherwise.
#pragma once

#include <cassert>
#include <cstddef>

namespace promenade::analysis {

template <typename Container>
auto& item(Container& values, int index) {
  assert(index >= 0 && static_cast<std::size_t>(index) < values.size() && "no such item");
  return values[static_cast<std::size_t>(index)];
}

template <typename Container>
int size_of(const Container& values) {
  return static_cast<int>(values.size());
}

}  // namespace promenade::analysis
