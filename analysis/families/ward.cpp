#include "motion/models/ward.h"

#include <string>

#include "analysis/families/family.h"

namespace promenade::analysis::families {
namespace {

// The convention of R: leaves are -1 to -n, merges are numbered from 1.
int r_number(int node, int leaves) { return node < leaves ? -node - 1 : node - leaves + 1; }

void put_merges(Json& result, const motion::Dendrogram& tree) {
  for (const char* key :
       {"height", "height_squared", "merge_id_a", "merge_id_b", "size", "R_merge"}) {
    result[key] = Json::array();
  }
  for (const motion::Merge& merge : tree.merges) {
    result["height"].push_back(merge.height);
    result["height_squared"].push_back(2 * merge.cost());
    result["merge_id_a"].push_back(merge.a);
    result["merge_id_b"].push_back(merge.b);
    result["size"].push_back(merge.size);
    // a < b is the order of R, too: leaves first, the smaller one before the larger.
    result["R_merge"].push_back(
        Json::array({r_number(merge.a, tree.leaves), r_number(merge.b, tree.leaves)}));
  }
  result["merged_members"] = motion::merged_leaves(tree);
}

// Centroids are sums of coordinates, and heights squares of distances.
void require_squares(const Eigen::MatrixXd& values) {
  if (values.cwiseAbs().maxCoeff() > 1e150) {
    throw CaseError("the input holds a number above 1e150, whose square is out of range");
  }
}

Eigen::MatrixXd distances_in(const Json& input) {
  const bool points = input.contains("points");
  const Eigen::MatrixXd values =
      points ? table(input, "points").transpose() : distance_table(input, "dist");
  require_squares(values);
  return points ? motion::euclidean_distances(values) : values;
}

// Of one leaf there is no pair to correlate.
Json correlation(const motion::Dendrogram& tree, const Eigen::MatrixXd& distances) {
  return tree.leaves < 2 ? Json() : to_json(motion::cophenetic_correlation(tree, distances));
}

}  // namespace

Json ward(const Json& input) {
  const bool points = input.contains("points");
  const Eigen::MatrixXd distances = distances_in(input);
  const motion::Dendrogram tree = points ? motion::ward(table(input, "points").transpose())
                                         : motion::ward_of_distances(distances);
  Json result = {{"n", tree.leaves}};
  put_merges(result, tree);
  for (int k = 2; k <= 4; ++k) {
    result["labels_k" + std::to_string(k)] = k <= tree.leaves ? Json(motion::cut(tree, k)) : Json();
  }
  result["cophenetic_correlation"] = correlation(tree, distances);
  return result;
}

}  // namespace promenade::analysis::families
