// A gallery (ours): what is shown walks in the middle of eight others, each a step on
// the way to one example. Picking one goes there and halves the step, so that a few
// picks come close to any mixture. Nothing has a name, and nothing can be set wrongly.
#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

#include "app/panel.h"
#include "app/registry.h"

namespace promenade::app {
namespace {

using study::Applied;
using study::ControlInput;
using study::InterfacePanel;
using study::InterfaceState;

constexpr int around = 8;
constexpr double first_step = 0.5, least_step = 1.0 / 16;

// The examples in an order in which any first few are as different as can be: each is
// the one farthest from the average and from those before it.
struct Directions final : study::InterfaceModel {
  explicit Directions(const motion::MotionSpace& space) {
    const Eigen::MatrixXd& x = space.offsets;
    Eigen::VectorXd away = (x.colwise() - x.rowwise().mean()).colwise().squaredNorm();
    for (int k = 0; k < space.set.size(); ++k) {
      int next = 0;
      away.maxCoeff(&next);
      order.push_back(next);
      const Eigen::VectorXd from_it = (x.colwise() - x.col(next)).colwise().squaredNorm();
      away = away.cwiseMin(from_it);
      for (const int taken : order) away(taken) = -1;
    }
  }
  std::vector<int> order;  // N
};

class Gallery final : public InterfaceState {
 public:
  explicit Gallery(const study::InterfaceContext& context)
      : set_(&context.space.set),
        model_(std::static_pointer_cast<const Directions>(context.model)),
        shown_(context.start) {}

  std::unique_ptr<InterfaceState> clone() const override {
    return std::make_unique<Gallery>(*this);
  }

  Applied apply(const ControlInput& input) override {
    if (input.kind == "pick") return pick(motion::find_cycle(*set_, input.target));
    if (input.kind == "step" && input.target == "larger") return set_step(2 * step_);
    if (input.kind == "step" && input.target == "smaller") return set_step(0.5 * step_);
    if (input.kind == "others" && pages() > 1) {
      page_ = (page_ + 1) % pages();
      return Applied::aside;
    }
    return Applied::refused;
  }

  void weights(std::int64_t, Eigen::VectorXd& weights) const override { weights = shown_; }

  // What the tile of an example shows.
  void neighbour(int cycle, Eigen::VectorXd& weights) const {
    weights = (1 - step_) * shown_;
    weights(cycle) += step_;
  }
  int pages() const { return (set_->size() + around - 1) / around; }
  int page() const { return page_; }
  double step() const { return step_; }
  const Eigen::VectorXd& shown() const { return shown_; }
  const motion::MotionSet& set() const { return *set_; }
  // The example behind tile k of this page; -1: none.
  int cycle_at(int k) const {
    const auto at = static_cast<std::size_t>(page_ * around + k);
    return at < model_->order.size() ? model_->order[at] : -1;
  }

 private:
  Applied pick(int cycle) {
    if (cycle < 0) return Applied::refused;
    Eigen::VectorXd next;
    neighbour(cycle, next);
    shown_ = next / next.sum();  // many picks must not add up rounding
    step_ = std::max(least_step, 0.5 * step_);
    return Applied::done;
  }
  Applied set_step(double step) {
    if (step > 1 || step < least_step) return Applied::refused;
    step_ = step;
    return Applied::aside;
  }

  const motion::MotionSet* set_;
  std::shared_ptr<const Directions> model_;
  Eigen::VectorXd shown_;
  double step_ = first_step;
  int page_ = 0;
};

std::vector<ControlInput> simulate(const InterfaceState& state, study::Rng& rng) {
  const auto& gallery = static_cast<const Gallery&>(state);
  std::vector<ControlInput> ideas;
  for (int k = 0; k < around; ++k) {
    const int cycle = gallery.cycle_at(k);
    if (cycle < 0) continue;
    ideas.push_back(
        {.kind = "pick", .target = gallery.set().cycles[static_cast<std::size_t>(cycle)].name});
  }
  rng.shuffle(ideas);
  if (gallery.pages() > 1 && rng.below(8) == 0) ideas.push_back({.kind = "others", .target = ""});
  return ideas;
}

void draw_tiles(const Gallery& gallery, InterfacePanel& panel, const Box& area) {
  static thread_local Eigen::VectorXd weights;  // scratch: a frame allocates nothing
  const float width = std::floor(area.width / 3);
  const float height = std::floor(area.height / 3);
  for (int place = 0; place < around + 1; ++place) {
    const Box tile{area.x + width * static_cast<float>(place % 3),
                   area.y + height * static_cast<float>(place / 3), width, height};
    if (place == around / 2) {
      panel.figure(tile, gallery.shown(), panel.look().palette.created);
      frame(tile, panel.look().palette.created, panel.size(3));
      continue;
    }
    const int cycle = gallery.cycle_at(place < around / 2 ? place : place - 1);
    if (cycle < 0) continue;
    gallery.neighbour(cycle, weights);
    panel.figure(tile, weights, panel.look().palette.example);
    panel.tile("pick", gallery.set().cycles[static_cast<std::size_t>(cycle)].name, tile);
  }
}

void draw(const InterfaceState& state, InterfacePanel& panel) {
  const auto& gallery = static_cast<const Gallery&>(state);
  const Box& box = panel.box();
  const float inset = panel.size(8);
  const float row = panel.size(40);
  const Box area{box.x + inset, box.y + inset, box.width - 2 * inset,
                 box.height - 2 * inset - 2 * row};
  draw_tiles(gallery, panel, area);
  const Box steps{area.x, area.bottom(), area.width, row};
  const float third = std::floor(area.width / 3);
  const app::Palette& palette = panel.look().palette;
  if (gallery.step() < 1) {
    panel.press("step", "larger", {steps.x + 2 * third, steps.y, third, row},
                panel.text("interface.gallery.larger"));
  }
  if (gallery.step() > least_step) {
    panel.press("step", "smaller", {steps.x, steps.y, third, row},
                panel.text("interface.gallery.smaller"));
  }
  // How large a step is: one notch for each halving.
  const double notches = std::log2(1 / least_step);
  const double share = (1 + notches + std::log2(gallery.step())) / (1 + notches);
  const Box bar{steps.x + third, steps.middle_y() - panel.size(4), third, panel.size(8)};
  fill(bar, palette.track);
  fill({bar.x, bar.y, std::round(bar.width * static_cast<float>(share)), bar.height},
       palette.created);
  if (gallery.pages() > 1) {
    panel.press("others", "", {area.x, steps.bottom(), area.width, row},
                panel.text("interface.gallery.others"));
  }
}

const InterfaceEntry entry{{
    .name = "gallery",
    .sentence =
        "Eight small walking figures around the one that is shown; picking one goes there and "
        "halves the step to the next eight.",
    .parameters = {},
    .texts = {"interface.gallery.title", "interface.gallery.hint", "interface.gallery.larger",
              "interface.gallery.smaller", "interface.gallery.others"},
    .shows_motion = true,
    .prepare =
        [](const study::InterfaceResources& resources, const study::Parameters&) {
          return study::PreparedModel{std::make_shared<Directions>(resources.space), ""};
        },
    .start = start_as<Gallery>,
    .simulate = simulate,
    .draw = draw,
}};

}  // namespace
}  // namespace promenade::app
