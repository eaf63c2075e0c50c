#include "app/parameter_sliders.h"

#include <algorithm>
#include <array>
#include <cassert>

namespace promenade::app {

using Eigen::VectorXd;
using study::Applied;
using study::ControlInput;

namespace {

bool in_range(double value) { return value >= 0 && value <= 1; }

double smooth_step(double x) { return x * x * (3 - 2 * x); }

}  // namespace

ParameterSliders::ParameterSliders(const study::InterfaceContext& context)
    : catalogue_(std::static_pointer_cast<const SliderCatalogue>(context.model)),
      set_(&context.space.set),
      start_(context.start),
      from_(context.start),
      target_(context.start) {
  assert(catalogue_ && "prepare() makes the catalogue");
  weights_visible_ = catalogue_->column != WeightsColumn::hidden;
  for (int k = 0; k < catalogue_->primary; ++k) sliders_.push_back({k, start_of(k)});
  sliders_changed(0);
}

std::unique_ptr<study::InterfaceState> ParameterSliders::clone() const {
  auto copy = std::make_unique<ParameterSliders>(*this);
  copy->list_ = List::closed;
  return copy;
}

double ParameterSliders::start_of(int parameter) const {
  return std::clamp(catalogue_->values.row(parameter).dot(start_), 0.0, 1.0);
}

double ParameterSliders::value_now(int parameter) const {
  return std::clamp(catalogue_->values.row(parameter).dot(target_), 0.0, 1.0);
}

int ParameterSliders::find_slider(int parameter) const {
  const auto found = std::find_if(sliders_.begin(), sliders_.end(), [&](const Slider& slider) {
    return slider.parameter == parameter;
  });
  return found == sliders_.end() ? -1 : static_cast<int>(found - sliders_.begin());
}

bool ParameterSliders::full() const {
  return sliders_.size() >= std::min<std::size_t>(most_sliders, catalogue_->parameters.size());
}

int ParameterSliders::slider_of(const Input& input) const {
  const int parameter = find_parameter(*catalogue_, input.target);
  return parameter < 0 ? -1 : find_slider(parameter);
}

int ParameterSliders::unused_parameter(const Input& input) const {
  const int parameter = find_parameter(*catalogue_, input.target);
  return parameter >= 0 && find_slider(parameter) < 0 ? parameter : -1;
}

Applied ParameterSliders::apply(const ControlInput& input) {
  struct Act {
    std::string_view kind;
    Applied (ParameterSliders::*act)(const Input&);
  };
  using Self = ParameterSliders;
  static constexpr std::array<Act, 9> acts = {{{"slide", &Self::slide},
                                               {"add", &Self::add},
                                               {"alter", &Self::alter},
                                               {"delete", &Self::remove},
                                               {"weight", &Self::weight},
                                               {"list", &Self::open_list},
                                               {"back", &Self::close_list},
                                               {"show", &Self::show_weights},
                                               {"hide", &Self::hide_weights}}};
  for (const Act& one : acts) {
    if (one.kind != input.kind) continue;
    const Applied applied = (this->*one.act)(input);
    if (applied == Applied::done && one.kind != "weight") held_ = -1;
    return applied;
  }
  return Applied::refused;
}

double ParameterSliders::eased(std::int64_t t_us) const {
  const double passed = static_cast<double>(t_us - began_us_) / static_cast<double>(ease_us);
  return smooth_step(std::clamp(passed, 0.0, 1.0));
}

void ParameterSliders::weights(std::int64_t t_us, VectorXd& weights) const {
  const double share = eased(t_us);
  weights = target_;
  if (share < 1) weights += (1 - share) * (from_ - target_);
}

// Undo eases the figure over as every change of the sliders does.
void ParameterSliders::restored(const InterfaceState& left, const VectorXd& shown,
                                std::int64_t t_us) {
  weights_visible_ = static_cast<const ParameterSliders&>(left).weights_visible_;
  from_ = shown;
  began_us_ = t_us;
}

double ParameterSliders::weight_at(std::int64_t t_us, int cycle) const {
  return target_(cycle) + (1 - eased(t_us)) * (from_(cycle) - target_(cycle));
}

std::vector<ControlInput> ParameterSliders::settings() const {
  std::vector<ControlInput> settings;
  for (const Slider& slider : sliders_) {
    const auto parameter = static_cast<std::size_t>(slider.parameter);
    settings.push_back(
        {.kind = "slide", .target = catalogue_->parameters[parameter].name, .value = slider.value});
  }
  return settings;
}

// What is shown now is where the figure comes from.
void ParameterSliders::ease_from(std::int64_t t_us) {
  VectorXd now;
  weights(t_us, now);
  from_ = std::move(now);
  began_us_ = t_us;
}

// Weights that the sliders ask for.
void ParameterSliders::aim() {
  VectorXd values(static_cast<Eigen::Index>(sliders_.size()));
  for (Eigen::Index k = 0; k < values.size(); ++k) {
    values(k) = sliders_[static_cast<std::size_t>(k)].value;
  }
  motion::raw_weights(*basis_, values, target_);
  motion::apply_rule(catalogue_->rule, target_);
}

// The sliders go where the weights are.
void ParameterSliders::follow() {
  for (Slider& slider : sliders_) slider.value = value_now(slider.parameter);
}

// Another set of sliders: what they show is fitted anew. Weights that no slider asked
// for stay until one is moved.
void ParameterSliders::sliders_changed(std::int64_t t_us) {
  list_ = List::closed;
  if (sliders_.empty()) {
    ease_from(t_us);
    target_ = start_;
    source_ = Source::start;
    return;
  }
  std::vector<int> rows;
  for (const Slider& slider : sliders_) rows.push_back(slider.parameter);
  basis_ = std::make_shared<const motion::RadialBasis>(
      motion::fit_radial_basis(catalogue_->values, rows));
  if (source_ != Source::sliders) return;
  ease_from(t_us);
  aim();
}

Applied ParameterSliders::slide(const Input& input) {
  const int slider = slider_of(input);
  if (slider < 0 || !in_range(input.value)) return Applied::refused;
  if (source_ != Source::sliders) ease_from(input.t_us);
  source_ = Source::sliders;
  sliders_[static_cast<std::size_t>(slider)].value = input.value;
  aim();
  return Applied::done;
}

Applied ParameterSliders::add(const Input& input) {
  const int parameter = unused_parameter(input);
  if (parameter < 0 || full()) return Applied::refused;
  sliders_.push_back({parameter, value_now(parameter)});
  sliders_changed(input.t_us);
  return Applied::done;
}

Applied ParameterSliders::alter(const Input& input) {
  const int parameter = unused_parameter(input);
  const int slider = slider_of({.kind = input.kind, .target = input.text});
  if (parameter < 0 || slider < 0) return Applied::refused;
  sliders_[static_cast<std::size_t>(slider)] = {parameter, value_now(parameter)};
  sliders_changed(input.t_us);
  return Applied::done;
}

Applied ParameterSliders::remove(const Input& input) {
  const int slider = slider_of(input);
  if (slider < 0) return Applied::refused;
  sliders_.erase(sliders_.begin() + slider);
  sliders_changed(input.t_us);
  return Applied::done;
}

Applied ParameterSliders::weight(const Input& input) {
  const int cycle = motion::find_cycle(*set_, input.target);
  const bool can = catalogue_->column == WeightsColumn::draggable && set_->size() > 1;
  if (!can || cycle < 0 || !in_range(input.value)) return Applied::refused;
  if (source_ != Source::hand) ease_from(input.t_us);
  source_ = Source::hand;
  if (held_ != cycle) proportions_ = target_;
  held_ = cycle;
  target_ = proportions_;
  // Negative weights have no proportion to keep.
  if (target_.minCoeff() < 0) motion::project_on_simplex(target_);
  target_(cycle) = 0;
  const double others = target_.sum();
  if (others > 1e-9) {
    target_ *= (1 - input.value) / others;
  } else {
    target_.setConstant((1 - input.value) / (set_->size() - 1));
  }
  target_(cycle) = input.value;
  follow();
  return Applied::done;
}

Applied ParameterSliders::open_list(const Input& input) {
  const int slider = slider_of(input);
  if (slider < 0 && (input.target != "add" || full())) return Applied::refused;
  list_ = slider < 0 ? List::adding : List::altering;
  altered_ = slider < 0 ? -1 : sliders_[static_cast<std::size_t>(slider)].parameter;
  return Applied::aside;
}

Applied ParameterSliders::close_list(const Input& input) {
  if (input.target != "list" || list_ == List::closed) return Applied::refused;
  list_ = List::closed;
  return Applied::aside;
}

Applied ParameterSliders::show_weights(const Input& input) {
  const bool can = catalogue_->column != WeightsColumn::hidden && !weights_visible_;
  if (input.target != "weights" || !can) return Applied::refused;
  weights_visible_ = true;
  return Applied::aside;
}

Applied ParameterSliders::hide_weights(const Input& input) {
  if (input.target != "weights" || !weights_visible_) return Applied::refused;
  weights_visible_ = false;
  return Applied::aside;
}

namespace {

std::vector<ControlInput> first_unused(const ParameterSliders& sliders) {
  std::vector<ControlInput> ideas;
  const auto& parameters = sliders.catalogue().parameters;
  for (std::size_t k = 0; k < parameters.size() && ideas.size() < 3; ++k) {
    if (sliders.find_slider(static_cast<int>(k)) >= 0) continue;
    ideas.push_back({.kind = "add", .target = parameters[k].name});
  }
  return ideas;
}

ControlInput random_slide(const ParameterSliders& sliders, study::Rng& rng) {
  const auto k = static_cast<std::size_t>(rng.below(sliders.sliders().size()));
  const auto parameter = static_cast<std::size_t>(sliders.sliders()[k].parameter);
  return {.kind = "slide",
          .target = sliders.catalogue().parameters[parameter].name,
          .value = rng.uniform()};
}

ControlInput random_weight(const ParameterSliders& sliders, study::Rng& rng) {
  const auto cycle = rng.below(static_cast<std::uint64_t>(sliders.set().size()));
  return {.kind = "weight",
          .target = sliders.set().cycles[static_cast<std::size_t>(cycle)].name,
          .value = rng.uniform()};
}

}  // namespace

std::vector<ControlInput> simulate_sliders(const study::InterfaceState& state, study::Rng& rng) {
  const auto& sliders = static_cast<const ParameterSliders&>(state);
  if (sliders.list() == ParameterSliders::List::altering) return {{"back", "list"}};
  if (sliders.list() == ParameterSliders::List::adding) return first_unused(sliders);
  if (sliders.sliders().empty()) return {{"list", "add"}};
  const bool drags =
      sliders.catalogue().column == WeightsColumn::draggable && sliders.weights_visible();
  std::vector<ControlInput> ideas;
  for (int k = 0; k < 4; ++k) {
    const bool by_hand = drags && rng.uniform() < 0.1;
    ideas.push_back(by_hand ? random_weight(sliders, rng) : random_slide(sliders, rng));
  }
  return ideas;
}

}  // namespace promenade::app
