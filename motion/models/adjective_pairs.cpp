#include "motion/models/adjective_pairs.h"

namespace promenade::motion {

std::string_view cluster_name(AdjectivePair::Cluster cluster) {
  static constexpr std::string_view names[] = {"", "quickness", "clearness", "activeness",
                                               "largeness"};
  return names[static_cast<int>(cluster)];
}

std::string pair_name(const AdjectivePair& pair) {
  return std::string(pair.left) + "-" + std::string(pair.right);
}

PairWords words_of_pair(std::string_view name) {
  const std::size_t hyphen = name.find('-');
  if (hyphen == std::string_view::npos) return {"", name};
  return {name.substr(0, hyphen), name.substr(hyphen + 1)};
}

int find_adjective_pair(std::string_view name) {
  const PairWords words = words_of_pair(name);
  for (std::size_t i = 0; i < adjective_pairs.size(); ++i) {
    const AdjectivePair& pair = adjective_pairs[i];
    if (pair.left == words.left && pair.right == words.right) return static_cast<int>(i);
  }
  return -1;
}

}  // namespace promenade::motion
