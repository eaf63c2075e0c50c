#include "analysis/report/figures/kinds.h"

#include <fmt/format.h>

#include <algorithm>

#include "analysis/item.h"

namespace promenade::analysis {
namespace {

// Letters and digits of a name, for a file; others become '-'.
std::string slug(const std::string& name) {
  std::string result;
  for (const char letter : name) {
    const bool plain = (letter >= 'a' && letter <= 'z') || (letter >= 'A' && letter <= 'Z') ||
                       (letter >= '0' && letter <= '9') || letter == '_';
    result += plain ? letter : '-';
  }
  return result.substr(0, 40);
}

}  // namespace

std::string figure_name(const Results& results, int task, const std::string& what) {
  if (results.data.tasks.size() < 2) return what;
  return fmt::format("{}-{}-{}", what, task + 1, slug(item(results.data.tasks, task).name));
}

std::string in_task(const Results& results, int task) {
  return results.data.tasks.size() < 2 ? "" : " in task " + item(results.data.tasks, task).name;
}

std::vector<int> interfaces_in(const Results& results, int task) {
  std::vector<int> used;
  for (int i = 0; i < size_of(results.data.interfaces); ++i) {
    const auto& trials = results.data.trials;
    const bool occurs = std::any_of(trials.begin(), trials.end(), [&](const Trial& trial) {
      return trial.task == task && trial.interface == i;
    });
    if (occurs) used.push_back(i);
  }
  return used;
}

std::vector<std::string> names_of(const Results& results, const std::vector<int>& interfaces) {
  std::vector<std::string> names;
  for (const int i : interfaces) names.push_back(item(results.data.interfaces, i));
  return names;
}

}  // namespace promenade::analysis
