// The density of values by a Gaussian kernel: what a violin shows.
//
//   f(x) = 1/(n h) sum_i phi((x - x_i) / h),  h = 0.9 min(s, IQR / 1.34) n^(-1/5)
//
// (Silverman 1986, Eq. 3.31; R's bw.nrd0). Where the quartiles coincide, h is that of s alone.
#pragma once

#include <optional>
#include <vector>

namespace promenade::analysis {

struct KernelDensity {
  double bandwidth = 0;         // h
  std::vector<double> at;       // from the smallest value to the largest, in equal steps
  std::vector<double> density;  // there; it would go on beyond both ends
};

// At `points` >= 2 places. Nothing for fewer than two values, or when all are the same.
std::optional<KernelDensity> kernel_density(const std::vector<double>& values, int points);

}  // namespace promenade::analysis
