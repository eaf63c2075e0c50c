#include "study/map_options.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace promenade::study {
namespace {

constexpr std::array<std::string_view, 4> heuristics = {"zero", "closest", "weights", "random"};

template <typename T>
T value_of(const Parameters& parameters, std::string_view name, T standard) {
  const auto found = parameters.find(name);
  return found == parameters.end() ? standard : std::get<T>(found->second);
}

int count_of(const Parameters& parameters, std::string_view name, int standard) {
  const auto wanted = value_of<double>(parameters, name, standard);
  return static_cast<int>(std::lround(std::clamp(wanted, 0.0, 1e6)));
}

}  // namespace

std::optional<motion::MapHeuristic> map_heuristic(std::string_view name) {
  const auto found = std::find(heuristics.begin(), heuristics.end(), name);
  if (found == heuristics.end()) return std::nullopt;
  return static_cast<motion::MapHeuristic>(found - heuristics.begin());
}

std::string_view name_of(motion::MapHeuristic heuristic) {
  return heuristics[static_cast<std::size_t>(heuristic)];
}

motion::MapOptions map_options(const Parameters& parameters) {
  motion::MapOptions options;
  const auto heuristic = value_of<std::string>(parameters, "heuristic", "closest");
  options.heuristic = map_heuristic(heuristic).value_or(options.heuristic);
  if (value_of<std::string>(parameters, "metric", "euclidean") == "mahalanobis") {
    options.metric = motion::MapMetric::mahalanobis;
  }
  options.components = count_of(parameters, "components", options.components);
  options.nearest = std::max(1, count_of(parameters, "nearest", options.nearest));
  options.glide_s = std::clamp(value_of(parameters, "glide_s", options.glide_s), 0.0, 10.0);
  return options;
}

}  // namespace promenade::study
