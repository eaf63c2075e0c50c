// Dot products of the centred columns of a tall table: the heavy half of a principal
// component analysis of few examples with thousands of numbers each.
#pragma once

#include <Eigen/Dense>

#include "motion/wide.h"

namespace promenade::motion {

// N x N: G_ij = (x_i - xbar)^T (x_j - xbar) of the columns of x (D x N), xbar their mean.
// Only the lower triangle is filled, the rest is 0. Every entry is summed in the same
// order whatever the processor can do, so the digits are the same everywhere. `wide` only where it
// can.
Eigen::MatrixXd centred_gram(const Eigen::Ref<const Eigen::MatrixXd>& x, bool wide = has_wide());

}  // namespace promenade::motion
