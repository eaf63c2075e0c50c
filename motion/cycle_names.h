// Names of cycles in a set: each once.
#pragma once

#include <map>
#include <set>
#include <string>

namespace promenade::motion {

// Gives names in the order of the takes: the one that is wanted, or the style and a number. A name
// that was given is not given again.
class CycleNames {
 public:
  std::string next(const std::string& style, const std::string& wanted);

 private:
  std::map<std::string, int> numbers_;
  std::set<std::string> taken_;
};

}  // namespace promenade::motion
