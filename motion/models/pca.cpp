#include "motion/models/pca.h"

#include <Eigen/Eigenvalues>
#include <Eigen/SVD>
#include <algorithm>
#include <cassert>
#include <cmath>

#include "motion/models/gram.h"

namespace promenade::motion {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double tie = 1e-9;  // relative: entries closer than that are of one size

// True when the entry of the largest size is negative; of several that tie, the
// first by name decides.
bool points_backwards(const VectorXd& entries, const std::vector<std::string>& names) {
  const double largest = entries.cwiseAbs().maxCoeff();
  Index chosen = -1;
  for (Index i = 0; i < entries.size(); ++i) {
    if (std::abs(entries(i)) < largest * (1 - tie)) continue;
    const bool first =
        chosen < 0 || (!names.empty() && names[static_cast<std::size_t>(i)] <
                                             names[static_cast<std::size_t>(chosen)]);
    if (first) chosen = i;
  }
  return chosen >= 0 && entries(chosen) < 0;
}

VectorXd deviations_of(const MatrixXd& centred) {
  return (centred.colwise().squaredNorm().transpose() / static_cast<double>(centred.rows() - 1))
      .cwiseSqrt();
}

}  // namespace

Pca principal_components(const Eigen::Ref<const MatrixXd>& x,
                         const std::vector<std::string>& names) {
  const Index n = x.cols();
  assert((names.empty() || static_cast<Index>(names.size()) == n) && "a name for each column");
  const MatrixXd gram = centred_gram(x);
  const Eigen::SelfAdjointEigenSolver<MatrixXd> solver(gram);
  const VectorXd values = solver.eigenvalues().reverse().cwiseMax(0);
  const Index kept = std::min<Index>(n - 1, (values.array() > values(0) * 1e-14).count());
  Pca pca;
  pca.coordinates.resize(kept, n);
  pca.variances = values.head(kept) / static_cast<double>(std::max<Index>(1, n - 1));
  pca.total_variance = values.sum() / static_cast<double>(std::max<Index>(1, n - 1));
  for (Index k = 0; k < kept; ++k) {
    const VectorXd axis = solver.eigenvectors().col(n - 1 - k) * std::sqrt(values(k));
    pca.coordinates.row(k) = (points_backwards(axis, names) ? -1 : 1) * axis.transpose();
  }
  return pca;
}

Pca principal_components(const MotionSpace& space) {
  std::vector<std::string> names;
  for (const Cycle& cycle : space.set.cycles) names.push_back(cycle.name);
  return principal_components(space.offsets.topRows(space.shape_rows()), names);
}

VectorXd coordinates_of(const Pca& pca, const VectorXd& weights) {
  assert(weights.size() == pca.size() && "one weight for each example");
  return pca.coordinates * weights;
}

VectorXd weights_of(const Pca& pca, const VectorXd& coordinates) {
  const Index k = coordinates.size();
  assert(k <= pca.components() && "no more coordinates than components");
  const VectorXd scaled = coordinates.cwiseQuotient(pca.variances.head(k)) / (pca.size() - 1);
  return pca.coordinates.topRows(k).transpose() * scaled +
         VectorXd::Constant(pca.size(), 1.0 / pca.size());
}

TablePca table_components(const MatrixXd& table, bool scale) {
  assert(table.rows() >= 2 && "a variance needs two observations");
  MatrixXd centred = table.rowwise() - table.colwise().mean();
  if (scale) {
    const VectorXd deviations = deviations_of(centred);
    for (Index c = 0; c < centred.cols(); ++c) {
      if (deviations(c) > 0) centred.col(c) /= deviations(c);
    }
  }
  const Eigen::JacobiSVD<MatrixXd> svd(centred, Eigen::ComputeThinU | Eigen::ComputeThinV);
  const VectorXd all = svd.singularValues() / std::sqrt(static_cast<double>(table.rows() - 1));
  const Index kept = (all.array() > all(0) * 1e-9).count();
  TablePca result;
  result.deviations = all.head(kept);
  result.explained = all.head(kept).cwiseAbs2() / all.squaredNorm();
  result.rotation = svd.matrixV().leftCols(kept);
  for (Index k = 0; k < kept; ++k) {
    if (points_backwards(result.rotation.col(k), {})) result.rotation.col(k) *= -1;
  }
  result.scores = centred * result.rotation;
  return result;
}

ClassicalScaling classical_scaling(const MatrixXd& distances, int k) {
  assert(distances.rows() == distances.cols() && "distances are a square");
  MatrixXd b = -0.5 * distances.cwiseAbs2();
  b.rowwise() -= b.colwise().mean().eval();
  b.colwise() -= b.rowwise().mean().eval();
  const Eigen::SelfAdjointEigenSolver<MatrixXd> solver(0.5 * (b + b.transpose()));
  ClassicalScaling result;
  result.eigenvalues = solver.eigenvalues().reverse();
  const double largest = result.eigenvalues.cwiseAbs().maxCoeff();
  result.eigenvalues = (result.eigenvalues.array().abs() < 1e-12 * largest)
                           .select(VectorXd::Zero(b.rows()), result.eigenvalues);
  const Index positive = (result.eigenvalues.array() > 0).count();
  const Index used = std::min<Index>(k, positive);
  result.points.resize(used, b.rows());
  for (Index a = 0; a < used; ++a) {
    const VectorXd axis =
        solver.eigenvectors().col(b.rows() - 1 - a) * std::sqrt(result.eigenvalues(a));
    result.points.row(a) = (points_backwards(axis, {}) ? -1 : 1) * axis.transpose();
  }
  const double first = result.eigenvalues.head(used).sum();
  result.goodness = {first / result.eigenvalues.cwiseAbs().sum(),
                     first / result.eigenvalues.head(positive).sum()};
  return result;
}

}  // namespace promenade::motion
