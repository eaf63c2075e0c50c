// Quantiles of Fisher's F distribution.
#pragma once

namespace promenade::analysis {

// The value that F with `above` and `below` degrees of freedom exceeds with probability p;
// infinite where no double holds it. 0 < p < 1, both degrees positive and finite.
double f_upper_quantile(double p, double above, double below);

}  // namespace promenade::analysis
