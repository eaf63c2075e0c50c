// Names for clusters: those that a source gave to the clusters that it found, where they
// overlap with ours.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace promenade::motion {

struct ClusterName {
  std::string name;      // "quickness", or the fallback of a cluster that is like none
  double agreement = 0;  // 0 to 1: 2 |shared| / (|ours| + |theirs|), the better of all tables
};

// For each item the name of the cluster that it is in; empty: in none.
using PrintedClusters = std::vector<std::string_view>;

// `cluster`: the label of each item, 0 to C-1; `fallback`: C names. Each printed name is
// given once, best agreement first, of several the first cluster.
std::vector<ClusterName> name_clusters(const std::vector<PrintedClusters>& tables,
                                       const std::vector<int>& cluster,
                                       const std::vector<std::string>& fallback);

// The two tables of the source for these pairs ("slow-fast"): set A, set B ([O] Tables 2
// and 3).
std::vector<PrintedClusters> printed_clusters(const std::vector<std::string>& pairs);

// The cluster of each of the 51 features in the source ([O] Tables 4 and 5, set B). The print has
// 50 names: v_step-length_front-back stands on both sides of the page break, and
// sigma_left-foot_left-right stands there twice; one of them is read as front-back. The 51st,
// sigma_com-velocity_left-right, is ours and in none.
PrintedClusters printed_feature_clusters();

}  // namespace promenade::motion
