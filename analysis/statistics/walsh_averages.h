// The averages of all pairs of differences, ordered but never written down: there
// are n(n+1)/2 of them, and the median needs one or two.
#pragma once

#include <cstdint>
#include <vector>

namespace promenade::analysis {

// The Walsh averages d_i/2 + d_j/2, i <= j, of finite values d.
class WalshAverages {
 public:
  explicit WalshAverages(const std::vector<double>& d);

  std::int64_t size() const;
  // The index-th smallest, from 0, in O(n) time.
  double operator[](std::int64_t index) const;

 private:
  std::int64_t count_up_to(double value) const;

  std::vector<double> halves_;  // sorted
};

}  // namespace promenade::analysis
