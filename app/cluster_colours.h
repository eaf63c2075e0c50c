// Colours of clusters of adjectives or features: apart for colour-blind readers, dark enough for
// words on white. Those of analysis/pictures/dendrogram_picture.cpp.
#pragma once

#include "app/look.h"

namespace promenade::app {

inline Rgb cluster_colour(int cluster) {
  static constexpr unsigned int colours[] = {0x0072b2, 0xd55e00, 0x009e73, 0xa03a78,
                                             0x8a6d00, 0x3a86b8, 0x555555, 0x7a4fb5};
  return cluster < 0 ? rgb(0x888888) : rgb(colours[cluster % 8]);
}

}  // namespace promenade::app
