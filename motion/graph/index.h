// Numbers of nodes, edges and walks are ints, so that -1 can say that there is none.
#pragma once

#include <cstddef>

namespace promenade::motion {

// As the index of a vector; not negative.
constexpr std::size_t at(int number) { return static_cast<std::size_t>(number); }

}  // namespace promenade::motion
