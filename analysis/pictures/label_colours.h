// A colour for each style in pictures of motion graphs, in the order of their names.
#pragma once

#include <string>
#include <vector>

#include "motion/graph/motion_graph.h"

namespace promenade::analysis {

class LabelColours {
 public:
  explicit LabelColours(const motion::MotionGraph& graph);
  const std::vector<std::string>& labels() const { return labels_; }  // sorted, each once
  int number(const std::string& label) const;                         // in labels(); it is there
  // "#0072b2": apart for colour-blind readers as far as eight styles; then they come again.
  std::string colour(const std::string& label) const;

 private:
  std::vector<std::string> labels_;
};

}  // namespace promenade::analysis
