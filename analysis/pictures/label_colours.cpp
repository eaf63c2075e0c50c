#include "analysis/pictures/label_colours.h"

#include <algorithm>
#include <array>

namespace promenade::analysis {

LabelColours::LabelColours(const motion::MotionGraph& graph)
    : labels_(motion::labels_of(graph.takes)) {}

int LabelColours::number(const std::string& label) const {
  return static_cast<int>(std::lower_bound(labels_.begin(), labels_.end(), label) -
                          labels_.begin());
}

std::string LabelColours::colour(const std::string& label) const {
  static constexpr std::array colours = {"#0072b2", "#d55e00", "#009e73", "#a03a78",
                                         "#8a6d00", "#3a86b8", "#555555", "#7a4fb5"};
  return colours[static_cast<std::size_t>(number(label)) % colours.size()];
}

}  // namespace promenade::analysis
