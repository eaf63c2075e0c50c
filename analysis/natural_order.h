// The order in which people sort codes and names.
#pragma once

#include <string_view>

namespace promenade::analysis {

// "P2" before "P10"; else by bytes. A strict weak order.
bool natural_less(std::string_view a, std::string_view b);

}  // namespace promenade::analysis
