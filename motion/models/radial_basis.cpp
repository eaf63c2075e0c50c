#include "motion/models/radial_basis.h"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

namespace promenade::motion {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

MatrixXd squared_distances(const MatrixXd& points) {
  MatrixXd squares(points.cols(), points.cols());
  for (Index i = 0; i < points.cols(); ++i) {
    squares(i, i) = 0;
    for (Index j = 0; j < i; ++j) {
      squares(i, j) = squares(j, i) = (points.col(i) - points.col(j)).squaredNorm();
    }
  }
  return squares;
}

// Group of each example: that of the first one at its place.
std::vector<int> group_examples(const MatrixXd& squares, double share) {
  const double same = share * share * squares.maxCoeff();
  std::vector<int> group(static_cast<std::size_t>(squares.cols()), -1);
  int groups = 0;
  for (std::size_t i = 0; i < group.size(); ++i) {
    for (std::size_t j = 0; j < i && group[i] < 0; ++j) {
      if (squares(static_cast<Index>(i), static_cast<Index>(j)) <= same) group[i] = group[j];
    }
    if (group[i] < 0) group[i] = groups++;
  }
  return group;
}

// Pc^+ of the M x G centred parameters, transposed: W_lin(p) = 1/G + linear (p - mean).
// From the smaller Gram matrix, which loses half of the digits of small singular
// values; they are cut.
MatrixXd linear_part(const MatrixXd& centred, double smallest) {
  assert(smallest >= 1e-4 && "smaller singular values drown in rounding");
  if (centred.size() == 0) return MatrixXd::Zero(centred.cols(), centred.rows());
  const bool wide = centred.rows() <= centred.cols();
  const MatrixXd gram =
      wide ? MatrixXd(centred * centred.transpose()) : MatrixXd(centred.transpose() * centred);
  const Eigen::SelfAdjointEigenSolver<MatrixXd> solver(gram);
  const VectorXd& squares = solver.eigenvalues();  // rising
  const double least = smallest * smallest * squares(squares.size() - 1);
  const Index kept = (squares.array() > least).count();
  const auto axes = solver.eigenvectors().rightCols(kept);
  const MatrixXd inverse = axes * squares.tail(kept).cwiseInverse().asDiagonal() * axes.transpose();
  return wide ? MatrixXd(centred.transpose() * inverse) : MatrixXd(inverse * centred.transpose());
}

VectorXd nearest_distances(MatrixXd squares) {
  squares.diagonal().setConstant(std::numeric_limits<double>::infinity());
  return squares.colwise().minCoeff().cwiseSqrt().transpose();
}

MatrixXd spline_matrix(const MatrixXd& squares, const VectorXd& radii) {
  MatrixXd values(squares.rows(), squares.cols());
  for (Index j = 0; j < squares.cols(); ++j) {
    const double scale = 1 / radii(j);
    for (Index k = 0; k < squares.rows(); ++k) {
      values(k, j) = cubic_spline(std::sqrt(squares(k, j)) * scale);
    }
  }
  return values;
}

// Solves R C = rest. In many dimensions the spline's matrix may be singular; narrower
// functions overlap less, and at half the distance R is 2/3 of the identity.
MatrixXd solve_coefficients(const MatrixXd& squares, const MatrixXd& rest, VectorXd& radii) {
  const VectorXd widest = radii;
  for (double width = 1;; width -= 0.1) {
    radii = width * widest;
    const Eigen::PartialPivLU<MatrixXd> lu(spline_matrix(squares, radii));
    if (lu.rcond() > 1e-8 || width < 0.55) return lu.solve(rest);
  }
}

RadialBasis uniform_weights(Index n, Index m) {
  RadialBasis basis;
  basis.mean = VectorXd::Zero(m);
  basis.base = VectorXd::Constant(n, 1.0 / static_cast<double>(n));
  basis.linear = MatrixXd::Zero(n, m);
  basis.centres.resize(m, 0);
  basis.coefficients.resize(n, 0);
  return basis;
}

// Fits examples that are all different.
RadialBasis fit_different(const MatrixXd& parameters, const MatrixXd& squares, double smallest) {
  const Index n = parameters.cols();
  RadialBasis basis;
  basis.mean = parameters.rowwise().mean();
  basis.base = VectorXd::Constant(n, 1.0 / static_cast<double>(n));
  const MatrixXd centred = parameters.colwise() - basis.mean;
  basis.linear = linear_part(centred, smallest);
  basis.centres = parameters;
  basis.radii = nearest_distances(squares);
  // W_lin has a row for each example: 1/N + Pc^T linear^T.
  MatrixXd rest = MatrixXd::Identity(n, n);
  rest.array() -= 1.0 / static_cast<double>(n);
  rest.noalias() -= centred.transpose() * basis.linear.transpose();
  basis.coefficients = solve_coefficients(squares, rest, basis.radii).transpose();
  return basis;
}

// Gives the weight of a group to its members, in equal shares.
MatrixXd shared(const MatrixXd& of_groups, const std::vector<int>& group) {
  VectorXd members = VectorXd::Zero(of_groups.rows());
  for (const int g : group) members(g) += 1;
  MatrixXd result(static_cast<Index>(group.size()), of_groups.cols());
  for (std::size_t i = 0; i < group.size(); ++i) {
    result.row(static_cast<Index>(i)) = of_groups.row(group[i]) / members(group[i]);
  }
  return result;
}

}  // namespace

double cubic_spline(double x) {
  x = std::abs(x);
  if (x < 1) return 2.0 / 3 - x * x + 0.5 * x * x * x;
  const double rest = 2 - x;
  return x < 2 ? rest * rest * rest / 6 : 0;
}

RadialBasis fit_radial_basis(const MatrixXd& parameters, const RadialBasisOptions& options) {
  const Index n = parameters.cols();
  assert(n > 0 && "there are examples");
  const MatrixXd squares = squared_distances(parameters);
  const std::vector<int> group = group_examples(squares, options.same_example);
  const int groups = 1 + *std::max_element(group.begin(), group.end());
  if (groups == 1) return uniform_weights(n, parameters.rows());
  if (groups == n) return fit_different(parameters, squares, options.smallest_singular);
  std::vector<int> first;
  for (int g = 0; g < groups; ++g) {
    first.push_back(static_cast<int>(std::find(group.begin(), group.end(), g) - group.begin()));
  }
  RadialBasis basis = fit_different(parameters(Eigen::all, first), squares(first, first),
                                    options.smallest_singular);
  basis.base = shared(basis.base, group);
  basis.linear = shared(basis.linear, group);
  basis.coefficients = shared(basis.coefficients, group);
  return basis;
}

RadialBasis fit_radial_basis(const MatrixXd& parameters, const std::vector<int>& rows,
                             const RadialBasisOptions& options) {
  return fit_radial_basis(MatrixXd(parameters(rows, Eigen::all)), options);
}

void raw_weights(const RadialBasis& basis, const VectorXd& parameters, VectorXd& raw) {
  assert(parameters.size() == basis.mean.size() && "one value for each parameter");
  raw = basis.base;
  for (Index m = 0; m < parameters.size(); ++m) {
    raw += basis.linear.col(m) * (parameters(m) - basis.mean(m));
  }
  for (Index j = 0; j < basis.centres.cols(); ++j) {
    const double reach = 2 * basis.radii(j);
    const double squared = (basis.centres.col(j) - parameters).squaredNorm();
    if (squared >= reach * reach) continue;
    raw += basis.coefficients.col(j) * cubic_spline(std::sqrt(squared) / basis.radii(j));
  }
}

VectorXd raw_weights(const RadialBasis& basis, const VectorXd& parameters) {
  VectorXd raw;
  raw_weights(basis, parameters, raw);
  return raw;
}

void apply_rule(NegativeRule rule, VectorXd& weights) {
  if (rule == NegativeRule::project) return project_on_simplex(weights);
  if (rule == NegativeRule::keep) return;
  weights = weights.cwiseMax(0).cwiseMin(1);
  weights /= weights.sum();
}

void project_on_simplex(VectorXd& weights) {
  assert(weights.size() > 0 && weights.allFinite() && "a point to project");
  // Michelot: the shift that the entries above it agree on; each round only drops
  // entries, so it ends after at most N rounds.
  Index above = weights.size();
  double shift = (weights.sum() - 1) / static_cast<double>(above);
  for (;;) {
    const auto positive = weights.array() > shift;
    const Index count = positive.count();
    if (count == above) break;
    above = count;
    shift = (positive.select(weights.array(), 0).sum() - 1) / static_cast<double>(above);
  }
  weights = (weights.array() - shift).max(0);
}

}  // namespace promenade::motion
