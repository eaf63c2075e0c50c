// Where in a text something stands.
#pragma once

namespace promenade {

struct Place {
  int line = 0, column = 0;  // from 1; 0: not at any place
};

}  // namespace promenade
