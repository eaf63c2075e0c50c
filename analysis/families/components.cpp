// The families pca and classical_mds: two sides of one decomposition.
#include "analysis/families/family.h"
#include "motion/models/pca.h"
#include "motion/models/ward.h"

namespace promenade::analysis::families {
namespace {

std::vector<double> list(const Eigen::VectorXd& values) { return {values.begin(), values.end()}; }

Json rows(const Eigen::MatrixXd& values) {
  Json result = Json::array();
  for (const auto& row : values.rowwise()) {
    result.push_back(list(row.transpose()));
  }
  return result;
}

// The upper triangle, row by row.
Json condensed(const Eigen::MatrixXd& distances) {
  Json result = Json::array();
  for (Eigen::Index i = 0; i < distances.rows(); ++i) {
    for (Eigen::Index j = i + 1; j < distances.cols(); ++j) result.push_back(distances(i, j));
  }
  return result;
}

}  // namespace

Json pca(const Json& input) {
  const Eigen::MatrixXd x = table(input, "X");
  const auto scale = input.find("scale");
  if (scale != input.end() && !scale->is_boolean()) {
    throw CaseError("input.scale is neither true nor false");
  }
  if (x.rows() < 2) throw CaseError("input.X has one row; a variance needs two");
  const motion::TablePca found =
      motion::table_components(x, scale != input.end() && scale->get<bool>());
  return {{"sdev", list(found.deviations)},
          {"explained_ratio", list(found.explained)},
          {"rotation", rows(found.rotation)},
          {"rank", found.deviations.size()},
          {"scores", rows(found.scores)}};
}

Json classical_mds(const Json& input) {
  const motion::ClassicalScaling found =
      motion::classical_scaling(distance_table(input, "dist"), whole_number(input, "k"));
  return {{"eig", list(found.eigenvalues)},
          {"k_used", found.points.rows()},
          {"config_distances_condensed", condensed(motion::euclidean_distances(found.points))},
          {"gof", Json::array({to_json(found.goodness[0]), to_json(found.goodness[1])})},
          {"points", rows(found.points.transpose())}};
}

}  // namespace promenade::analysis::families
