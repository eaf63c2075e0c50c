#include "motion/models/adjective_pairs.h"

namespace promenade::motion {

std::string_view cluster_name(AdjectivePair::Cluster cluster) {
  static constexpr std::string_view names[] = {"", "quickness", "clearness", "activeness",
                                               "largeness"};
  return names[static_cast<int>(cluster)];
}

int find_adjective_pair(std::string_view name) {
  const std::size_t dash = name.find('-');
  if (dash == std::string_view::npos) return -1;
  for (std::size_t i = 0; i < adjective_pairs.size(); ++i) {
    const AdjectivePair& pair = adjective_pairs[i];
    if (pair.left == name.substr(0, dash) && pair.right == name.substr(dash + 1)) {
      return static_cast<int>(i);
    }
  }
  return -1;
}

}  // namespace promenade::motion
