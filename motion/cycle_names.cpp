#include "motion/cycle_names.h"

namespace promenade::motion {

std::string CycleNames::next(const std::string& style, const std::string& wanted) {
  const std::string& stem = wanted.empty() ? style : wanted;
  std::string name = wanted;
  while (name.empty() || taken_.contains(name)) {
    name = stem + "_" + std::to_string(++numbers_[stem]);
  }
  taken_.insert(name);
  return name;
}

}  // namespace promenade::motion
