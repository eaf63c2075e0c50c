#include "motion/models/cluster_names.h"

#include <algorithm>
#include <cassert>

#include "motion/models/adjective_pairs.h"
#include "motion/models/features.h"

namespace promenade::motion {
namespace {

struct Overlap {
  std::size_t cluster = 0;
  std::string_view name;
  double agreement = 0;
};

double agreement_of(const PrintedClusters& table, const std::vector<int>& cluster, int label,
                    std::string_view name) {
  int ours = 0;
  int theirs = 0;
  int shared = 0;
  for (std::size_t i = 0; i < cluster.size(); ++i) {
    const bool there = table[i] == name;
    ours += cluster[i] == label;
    theirs += there;
    shared += there && cluster[i] == label;
  }
  return ours + theirs > 0 ? 2.0 * shared / (ours + theirs) : 0;
}

// In the order of their first item.
std::vector<std::string_view> names_in(const std::vector<PrintedClusters>& tables) {
  std::vector<std::string_view> names;
  for (const PrintedClusters& table : tables) {
    for (const std::string_view name : table) {
      const bool known = std::find(names.begin(), names.end(), name) != names.end();
      if (!name.empty() && !known) names.push_back(name);
    }
  }
  return names;
}

// Every cluster with every name, the best first.
std::vector<Overlap> overlaps(const std::vector<PrintedClusters>& tables,
                              const std::vector<int>& cluster, std::size_t clusters) {
  std::vector<Overlap> result;
  for (std::size_t c = 0; c < clusters; ++c) {
    for (const std::string_view name : names_in(tables)) {
      double best = 0;
      for (const PrintedClusters& table : tables) {
        best = std::max(best, agreement_of(table, cluster, static_cast<int>(c), name));
      }
      if (best > 0) result.push_back({c, name, best});
    }
  }
  std::stable_sort(result.begin(), result.end(),
                   [](const Overlap& a, const Overlap& b) { return a.agreement > b.agreement; });
  return result;
}

}  // namespace

std::vector<ClusterName> name_clusters(const std::vector<PrintedClusters>& tables,
                                       const std::vector<int>& cluster,
                                       const std::vector<std::string>& fallback) {
  std::vector<ClusterName> names(fallback.size());
  std::vector<std::string_view> taken;
  for (const Overlap& overlap : overlaps(tables, cluster, names.size())) {
    const bool used = std::find(taken.begin(), taken.end(), overlap.name) != taken.end();
    if (used || !names[overlap.cluster].name.empty()) continue;
    names[overlap.cluster] = {std::string(overlap.name), overlap.agreement};
    taken.push_back(overlap.name);
  }
  for (std::size_t c = 0; c < names.size(); ++c) {
    if (names[c].name.empty()) names[c].name = fallback[c];
  }
  return names;
}

std::vector<PrintedClusters> printed_clusters(const std::vector<std::string>& pairs) {
  std::vector<PrintedClusters> tables(2);
  for (const std::string& name : pairs) {
    const int found = find_adjective_pair(name);
    const AdjectivePair pair =
        found < 0 ? AdjectivePair{} : adjective_pairs[static_cast<std::size_t>(found)];
    tables[0].push_back(cluster_name(pair.set_a));
    tables[1].push_back(cluster_name(pair.set_b));
  }
  return tables;
}

PrintedClusters printed_feature_clusters() {
  struct Cluster {
    std::string_view name;
    std::vector<std::string_view> features;  // beginnings of their names
  };
  // Features that no row names but the 51st are in the last printed cluster.
  static const std::vector<Cluster> printed = {
      {"", {"sigma_com-velocity_left-right"}},
      {"lateral swing of the upper body", {"sigma_torso", "sigma_head", "sigma_com_left-right"}},
      {"front-back swing of the arms and legs",
       {"sigma_left-upper-arm", "sigma_right-upper-arm", "sigma_left-forearm",
        "sigma_right-forearm", "sigma_left-thigh", "sigma_right-thigh",
        "sigma_com-position_vertical", "sigma_com-velocity_vertical"}},
      {"bending angle of the upper body",
       {"mu_torso", "mu_head", "mu_left-upper-arm", "mu_right-upper-arm", "mu_left-forearm",
        "mu_right-forearm", "mu_left-thigh", "mu_right-thigh_front-back",
        "mu_right-foot_left-right", "mu_com-velocity_left-right", "v_step-length_left-right"}},
      {"step length", {""}},
  };
  PrintedClusters clusters;
  for (const std::string_view feature : feature_names()) {
    const auto holds = [feature](const Cluster& cluster) {
      return std::any_of(
          cluster.features.begin(), cluster.features.end(),
          [feature](std::string_view beginning) { return feature.rfind(beginning, 0) == 0; });
    };
    clusters.push_back(std::find_if(printed.begin(), printed.end(), holds)->name);
  }
  return clusters;
}

}  // namespace promenade::motion
