// Adjusted p-values of a family of tests, in the order given. With
// p_(1) <= ... <= p_(m):
//   bonferroni  min(1, m p)
//   holm        running maximum over k of (m-k+1) p_(k)      (Holm 1979)
//   hochberg    running minimum from above of (m-k+1) p_(k)  (Hochberg 1988)
//   bh          running minimum from above of m p_(k) / k    (Benjamini & Hochberg 1995)
//   by          bh times sum 1/i, i = 1..m                   (Benjamini & Yekutieli 2001)
#pragma once

#include <vector>

namespace promenade::analysis {

std::vector<double> adjust_bonferroni(std::vector<double> p);
std::vector<double> adjust_holm(const std::vector<double>& p);
std::vector<double> adjust_hochberg(const std::vector<double>& p);
std::vector<double> adjust_bh(const std::vector<double>& p);
std::vector<double> adjust_by(const std::vector<double>& p);

}  // namespace promenade::analysis
