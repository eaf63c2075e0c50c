// From parameters (adjectives, features) to blend weights: a linear map plus cubic
// radial basis functions, in cardinal form ([O] Eq. 7; Rose 1998, Park 2004;
// docs/methods.md, 8). The raw weights are e_j at example j and sum to 1 everywhere. Fit it
// again whenever the set of sliders changes: any number of them works.
#pragma once

#include <Eigen/Dense>
#include <vector>

namespace promenade::motion {

struct RadialBasisOptions {
  // Directions of the parameters in which the examples vary less than this share of
  // the widest are left to the basis functions: there the linear weights explode.
  // At least 1e-4.
  double smallest_singular = 0.02;
  // Examples closer than this share of the examples' diameter count as one, whose
  // weight they share: a basis function needs a radius.
  double same_example = 1e-6;
};

// G <= N groups of examples with different parameters.
struct RadialBasis {
  Eigen::VectorXd mean;          // M: of the groups' parameters
  Eigen::VectorXd base;          // N: weights at the mean, linear part
  Eigen::MatrixXd linear;        // N x M
  Eigen::MatrixXd centres;       // M x G
  Eigen::VectorXd radii;         // G: a_j
  Eigen::MatrixXd coefficients;  // N x G: row j of C in column j

  int size() const { return static_cast<int>(base.size()); }
};

// Of parameters M x N, one column an example, on comparable scales (0 to 1 of a
// slider). M may be 0 (all weights 1/N) or exceed N.
RadialBasis fit_radial_basis(const Eigen::MatrixXd& parameters, const RadialBasisOptions& = {});

// The same with some of the parameters only (rows of `parameters`).
RadialBasis fit_radial_basis(const Eigen::MatrixXd& parameters, const std::vector<int>& rows,
                             const RadialBasisOptions& = {});

// Cubic B-spline of Rose 1998: 2/3 at 0, 1/6 at 1, 0 from 2 on.
double cubic_spline(double x);

// N weights that sum to 1, some may be negative. Allocation-free when `raw` has N.
void raw_weights(const RadialBasis& basis, const Eigen::VectorXd& parameters, Eigen::VectorXd& raw);
Eigen::VectorXd raw_weights(const RadialBasis& basis, const Eigen::VectorXd& parameters);

// What becomes of negative weights: clamped to [0, 1] and normalised (the source);
// kept; or the nearest point of the simplex.
enum class NegativeRule { clamp, keep, project };

void apply_rule(NegativeRule rule, Eigen::VectorXd& weights);

// Euclidean projection on {w >= 0, sum w = 1}, exact, in place.
void project_on_simplex(Eigen::VectorXd& weights);

}  // namespace promenade::motion
