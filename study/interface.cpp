#include "study/interface.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>

namespace promenade::study {

std::string to_text(const ParameterValue& value) {
  if (const bool* flag = std::get_if<bool>(&value)) return *flag ? "true" : "false";
  if (const double* number = std::get_if<double>(&value)) return fmt::format("{}", *number);
  return std::get<std::string>(value);
}

Eigen::VectorXd weights_of(const InterfaceState& state, std::int64_t t_us) {
  Eigen::VectorXd weights;
  state.weights(t_us, weights);
  return weights;
}

void InterfaceRegistry::add(InterfaceType type) {
  assert(!find(type.name) && "an interface is declared once");
  types_.push_back(std::move(type));
  std::sort(types_.begin(), types_.end(),
            [](const InterfaceType& a, const InterfaceType& b) { return a.name < b.name; });
}

const InterfaceType* InterfaceRegistry::find(std::string_view name) const {
  for (const InterfaceType& type : types_) {
    if (type.name == name) return &type;
  }
  return nullptr;
}

}  // namespace promenade::study
