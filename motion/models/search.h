// The least value of a function over a box, without derivatives: Nelder-Mead in few
// dimensions, with coordinate steps after it to leave false minima. Deterministic.
#pragma once

#include <Eigen/Dense>
#include <functional>

namespace promenade::motion {

struct Box {
  Eigen::VectorXd low, high;  // both ends belong to it

  int size() const { return static_cast<int>(low.size()); }
};

struct SearchOptions {
  double first_step = 0.15;     // share of each side of the box
  double smallest_step = 1e-4;  // the search ends there
  int evaluations = 2000;       // at most, about
};

struct SearchResult {
  Eigen::VectorXd at;
  double value = 0;
  int evaluations = 0;
};

using Objective = std::function<double(const Eigen::VectorXd&)>;

SearchResult minimise(const Objective& objective, const Box& box, const Eigen::VectorXd& start,
                      const SearchOptions& = {});

}  // namespace promenade::motion
