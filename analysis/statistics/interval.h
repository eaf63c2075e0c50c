// A confidence interval. Which level and which kind stands where it is made.
#pragma once

namespace promenade::analysis {

struct Interval {
  double lower = 0;
  double upper = 0;
};

}  // namespace promenade::analysis
