#include "app/minimap.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <utility>

#include "motion/convex_hull.h"
#include "motion/models/ward.h"
#include "study/map_options.h"

namespace promenade::app {
namespace {

using Eigen::Vector2d;
using study::Applied;
using study::ControlInput;

constexpr double margin = 1.06;    // around the region that is known
constexpr int clusters_shown = 3;  // the primary ones of [N]

std::vector<std::vector<int>> outlines(const motion::Pca& pca, const Eigen::Matrix2Xd& points) {
  const int count = std::min(clusters_shown, pca.size());
  const std::vector<int> label = motion::cut(motion::ward(pca.coordinates), count);
  std::vector<std::vector<int>> members(static_cast<std::size_t>(count));
  for (int i = 0; i < pca.size(); ++i) {
    members[static_cast<std::size_t>(label[static_cast<std::size_t>(i)])].push_back(i);
  }
  for (std::vector<int>& columns : members)
    columns = motion::convex_hull(points, std::move(columns));
  return members;
}

const MinimapModel& model_in(const study::InterfaceContext& context) {
  assert(context.model && "made by prepare_minimap");
  return static_cast<const MinimapModel&>(*context.model);
}

bool is(const study::Parameters& parameters, std::string_view name) {
  return std::get<bool>(parameters.find(name)->second);
}

}  // namespace

study::PreparedModel prepare_minimap(const study::InterfaceResources& resources,
                                     const study::Parameters& parameters) {
  const motion::Pca pca = motion::principal_components(resources.space);
  if (pca.components() == 0) return {nullptr, "all cycles of the set are alike"};
  auto model = std::make_shared<MinimapModel>();
  motion::MapOptions options = study::map_options(parameters);
  for (std::size_t h = 0; h < model->maps.size(); ++h) {
    options.heuristic = static_cast<motion::MapHeuristic>(h);
    model->maps[h] = motion::make_minimap(pca, options);
  }
  model->radii = motion::valid_radii(model->maps[0]);
  model->half = margin * model->radii.maxCoeff();
  model->clusters = outlines(pca, model->maps[0].examples);
  return {std::move(model), ""};
}

MinimapState::MinimapState(const study::InterfaceContext& context)
    : model_(std::static_pointer_cast<const MinimapModel>(context.model)),
      start_(context.start),
      shelf_(context.space.set, &model_in(context).maps[0].examples, context.start),
      rng_(context.seed, 0, "map"),
      heuristic_(study::map_options(context.parameters).heuristic),
      has_switch_(is(context.parameters, "switch")),
      names_always_(std::get<std::string>(context.parameters.at("names")) == "always"),
      shows_clusters_(is(context.parameters, "clusters")),
      cursor_(motion::start_map(map())) {}

std::unique_ptr<study::InterfaceState> MinimapState::clone() const {
  return std::make_unique<MinimapState>(*this);
}

const motion::Minimap& MinimapState::map() const {
  return model_->maps[static_cast<std::size_t>(heuristic_)];
}

Vector2d MinimapState::point() const {
  if (shelf_.shown() != Shelf::Shown::own) return shelf_.point();
  return touched_ ? cursor_.point : Vector2d(map().examples * start_);
}

Applied MinimapState::apply(const ControlInput& input) {
  if (input.kind == "point") return apply_point(input) ? Applied::done : Applied::refused;
  if (input.kind == "heuristic") return switch_to(input);
  if (input.kind == "zoom" || input.kind == "pan" || input.kind == "whole") return look(input);
  if (input.kind == "go") {
    const int example = motion::find_cycle(shelf_.set(), input.target);
    if (example < 0) return Applied::refused;
    shelf_.go({.example = example});
    pulled_back_ = false;
    return Applied::done;
  }
  const Applied applied = shelf_.apply(input, {study::weights_of(*this, input.t_us), point()});
  if (applied == Applied::done && shelf_.shown() != Shelf::Shown::own) pulled_back_ = false;
  return applied;
}

bool MinimapState::apply_point(const ControlInput& input) {
  const Vector2d wanted(input.x, input.y);
  const bool on_map = wanted.allFinite() && wanted.cwiseAbs().maxCoeff() <= model_->half;
  if (input.target != "map" || !on_map) return false;
  move_to(wanted, input.value != 1, input.t_us);
  return true;
}

void MinimapState::move_to(const Vector2d& wanted, bool pick, std::int64_t t_us) {
  const std::int64_t now_us = std::max(t_us, cursor_.t_us);
  take_over(now_us);
  cursor_ = motion::move(map(), std::move(cursor_), {wanted, pick, now_us},
                         [this] { return rng_.normal(); });
  pulled_back_ = (cursor_.point - wanted).norm() > 1e-9 * model_->half;
  touched_ = true;
  shelf_.leave();
}

// What glides begins where the figure is: at an example, a bookmark, a mixture, the start.
void MinimapState::take_over(std::int64_t t_us) {
  const bool own = shelf_.shown() == Shelf::Shown::own && touched_;
  if (own || heuristic_ != motion::MapHeuristic::closest) return;
  cursor_.rest = cursor_.goal = map().rest * study::weights_of(*this, t_us);
  cursor_.t_us = t_us;
}

Applied MinimapState::switch_to(const ControlInput& input) {
  const auto wanted = study::map_heuristic(input.target);
  if (!has_switch_ || !wanted) return Applied::refused;
  if (*wanted == heuristic_) return Applied::aside;
  heuristic_ = *wanted;
  const motion::MapState before = std::exchange(cursor_, motion::start_map(map()));
  cursor_.point = before.point;
  cursor_.t_us = std::max(before.t_us, input.t_us);
  // An example, a bookmark or a mixture stays as it is until the point is moved.
  if (touched_ && shelf_.shown() == Shelf::Shown::own) move_to(before.point, true, input.t_us);
  return Applied::done;
}

Applied MinimapState::look(const ControlInput& input) {
  const Vector2d centre(input.x, input.y);
  const bool moves = input.kind != "whole";
  if (input.target != "map" || (moves && !centre.allFinite())) return Applied::refused;
  MapSight sight = sight_;
  if (input.kind == "whole") sight = {};
  if (input.kind == "zoom") {
    if (!(input.value >= 1 && input.value <= closest_zoom)) return Applied::refused;
    sight.zoom = input.value;
  }
  const double room = model_->half * (1 - 1 / sight.zoom);
  if (moves) sight.centre = centre.cwiseMax(-room).cwiseMin(room);
  sight_ = sight;
  return Applied::aside;
}

void MinimapState::weights(std::int64_t t_us, Eigen::VectorXd& weights) const {
  if (shelf_.weights(weights)) return;
  if (touched_) {
    motion::weights_at(map(), cursor_, t_us, weights);
  } else {
    weights = start_;
  }
}

std::vector<ControlInput> MinimapState::settings() const {
  std::vector<ControlInput> settings;
  shelf_.add_settings(settings);
  if (shelf_.shown() == Shelf::Shown::own) {
    const Vector2d at = point();
    settings.push_back({.kind = "point", .target = "map", .x = at.x(), .y = at.y()});
  } else if (shelf_.current().example >= 0) {
    settings.push_back({.kind = "go", .target = std::string(shelf_.target_of(shelf_.current()))});
  }
  return settings;
}

}  // namespace promenade::app
