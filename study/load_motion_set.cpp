// Only builtin sets for now; recipes and files come with the captures.
#include "motion/builtin.h"
#include "study/study.h"

namespace promenade::study {

motion::MotionSet load_motion_set(const std::string& name, const std::string& folder) {
  constexpr std::string_view prefix = "builtin:";
  if (name.rfind(prefix, 0) == 0) {
    if (auto set = motion::builtin_set(name.substr(prefix.size()))) return std::move(*set);
  }
  throw InputError(folder.empty() ? name : folder + "/" + name, "is not a motion set");
}

}  // namespace promenade::study
