#include "motion/models/control_maps.h"

#include <cassert>
#include <memory>

#include "motion/models/adjectives.h"
#include "motion/models/cluster_names.h"
#include "motion/models/features.h"

namespace promenade::motion {
namespace {

using Eigen::MatrixXd;
using Eigen::Vector2d;
using Eigen::VectorXd;

constexpr double map_margin = 0.1;  // of the dots' extent, beyond the outermost ones

VectorXd equal_weights(int n) { return VectorXd::Constant(n, 1.0 / n); }

Box unit_box(int size) { return {VectorXd::Zero(size), VectorXd::Ones(size)}; }

Box box_of_dots(const Minimap& map) {
  const Vector2d low = map.examples.rowwise().minCoeff();
  const Vector2d high = map.examples.rowwise().maxCoeff();
  const Vector2d margin = map_margin * (high - low);
  return {low - margin, high + margin};
}

}  // namespace

std::optional<ControlMap> map_controls(const MotionSpace& space, const MapOptions& options) {
  const Pca pca = principal_components(space);
  if (pca.components() == 0) return std::nullopt;
  MapOptions settled = options;
  settled.glide_s = 0;
  const auto map = std::make_shared<const Minimap>(make_minimap(pca, settled));
  ControlMap result{"map", {"x", "y"}, {}, {}};
  result.problem.weights = [map, rest = start_map(*map)](const VectorXd& at, VectorXd& weights) {
    const MapState state = move(*map, rest, {at, true, 0}, [] { return 0.0; });
    weights_at(*map, state, 0, weights);
  };
  result.problem.box = box_of_dots(*map);
  result.problem.start = equal_weights(space.set.size());
  for (const auto& dot : map->examples.colwise()) result.problem.guesses.emplace_back(dot);
  // The map is linear in the weights: the target's own place is their blend.
  result.guess = [map](const VectorXd& target) -> VectorXd { return map->examples * target; };
  result.shows_examples = true;  // a press on a dot
  return result;
}

ControlMap label_controls(const MotionSet& set) {
  const int n = set.size();
  ControlMap result{"labels", {"label"}, {}, {}};
  result.problem.start = equal_weights(n);
  for (int i = 0; i < n; ++i) result.problem.choices.emplace_back(VectorXd::Unit(n, i));
  return result;
}

ControlMap weight_controls(const MotionSet& set) {
  const int n = set.size();
  ControlMap result{"weights", names_of(set), {}, {}};
  result.problem.weights = [](const VectorXd& at, VectorXd& weights) {
    const double sum = at.sum();
    if (sum > 0) {
      weights = at / sum;
    } else {
      weights.setConstant(1.0 / static_cast<double>(at.size()));
    }
  };
  result.problem.box = unit_box(n);
  result.problem.start = equal_weights(n);
  result.guess = [](const VectorXd& target) -> VectorXd {
    VectorXd nearest = target;
    project_on_simplex(nearest);
    return nearest / nearest.maxCoeff();
  };
  return result;
}

ControlMap slider_controls(const std::string& name, const std::vector<std::string>& controls,
                           const MatrixXd& parameters, NegativeRule rule) {
  assert(static_cast<Eigen::Index>(controls.size()) == parameters.rows() && "a name for each");
  const auto basis = std::make_shared<const RadialBasis>(fit_radial_basis(parameters));
  ControlMap result{name, controls, {}, {}};
  result.problem.weights = [basis, rule](const VectorXd& at, VectorXd& weights) {
    raw_weights(*basis, at, weights);
    apply_rule(rule, weights);
  };
  result.problem.box = unit_box(static_cast<int>(parameters.rows()));
  result.problem.start = equal_weights(static_cast<int>(parameters.cols()));
  for (const auto& example : parameters.colwise()) result.problem.guesses.emplace_back(example);
  result.guess = [parameters](const VectorXd& target) -> VectorXd { return parameters * target; };
  return result;
}

FeatureSliders feature_sliders(const MotionSet& set, int clusters) {
  const Quantification found = cluster_rows(scaled_to_range(motion_features(set)), clusters);
  FeatureSliders sliders;
  sliders.cluster = found.cluster;
  sliders.tree = found.tree;
  sliders.parameters = scaled_to_range(found.primary);
  std::vector<std::string> fallback;
  for (Eigen::Index c = 0; c < found.primary.rows(); ++c) {
    fallback.push_back("cluster " + std::to_string(c + 1));
  }
  for (ClusterName& name : name_clusters({printed_feature_clusters()}, found.cluster, fallback)) {
    sliders.names.push_back(std::move(name.name));
    sliders.agreement.push_back(name.agreement);
  }
  return sliders;
}

ReachProblem problem_of(const ControlMap& map, const VectorXd& target) {
  ReachProblem problem = map.problem;
  if (map.guess) problem.guesses.push_back(map.guess(target));
  return problem;
}

}  // namespace promenade::motion
