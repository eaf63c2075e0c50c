// Blend weights ([O] 4.2): one slider for each motion of the set. The sliders are
// divided by their sum at once, so that moving one changes only the bars of the
// others.
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

constexpr double slider_start = 0.5;

class Weights final : public InterfaceState {
 public:
  explicit Weights(const study::InterfaceContext& context)
      : set_(&context.space.set),
        start_(context.start),
        has_only_(std::get<bool>(context.parameters.at("only"))),
        sliders_(Eigen::VectorXd::Constant(context.start.size(), slider_start)) {}

  std::unique_ptr<InterfaceState> clone() const override {
    return std::make_unique<Weights>(*this);
  }

  Applied apply(const ControlInput& input) override {
    if (input.kind == "reset") {
      sliders_.setConstant(slider_start);
      return Applied::done;
    }
    const int cycle = motion::find_cycle(*set_, input.target);
    if (cycle < 0) return Applied::refused;
    if (input.kind == "slide" && input.value >= 0 && input.value <= 1) {
      sliders_(cycle) = input.value;
      return Applied::done;
    }
    if (input.kind == "only" && has_only_) {
      sliders_ = Eigen::VectorXd::Unit(sliders_.size(), cycle);
      return Applied::done;
    }
    return Applied::refused;
  }

  // All at zero asks for nothing: the start is shown.
  void weights(std::int64_t, Eigen::VectorXd& weights) const override {
    const double sum = sliders_.sum();
    if (sum > 0 && std::isfinite(1 / sum)) {
      weights = sliders_ / sum;
    } else {
      weights = start_;
    }
  }

  std::vector<ControlInput> settings() const override {
    std::vector<ControlInput> settings;
    for (int i = 0; i < set_->size(); ++i) {
      settings.push_back({.kind = "slide",
                          .target = set_->cycles[static_cast<std::size_t>(i)].name,
                          .value = sliders_(i)});
    }
    return settings;
  }

  const motion::MotionSet& set() const { return *set_; }
  const Eigen::VectorXd& sliders() const { return sliders_; }
  bool has_only() const { return has_only_; }

 private:
  const motion::MotionSet* set_;
  Eigen::VectorXd start_;
  bool has_only_;
  Eigen::VectorXd sliders_;
};

// A few sliders at a few places; now and then one style alone.
std::vector<ControlInput> simulate(const InterfaceState& state, study::Rng& rng) {
  const auto& weights = static_cast<const Weights&>(state);
  const auto count = static_cast<std::uint64_t>(weights.set().size());
  std::vector<ControlInput> ideas;
  for (int k = 0; k < 4; ++k) {
    const auto cycle = static_cast<std::size_t>(rng.below(count));
    const std::string& name = weights.set().cycles[cycle].name;
    if (weights.has_only() && rng.uniform() < 0.15) {
      ideas.push_back({.kind = "only", .target = name, .value = 1});
    } else {
      ideas.push_back({.kind = "slide", .target = name, .value = rng.uniform()});
    }
  }
  return ideas;
}

// Where the parts of a row lie, pixels.
struct Columns {
  Box name, slider, bar, percent, only;
};

Columns columns_of(const InterfacePanel& panel, const Box& row, bool has_only) {
  const auto part = [&](float from, float width) -> Box {
    return {row.x + panel.size(from), row.y, panel.size(width), row.height};
  };
  const float left = has_only ? 0 : 48;  // the room of the button goes to the slider
  return {part(12, 112), part(124, 140 + left), part(268 + left, 36), part(306 + left, 46),
          part(354, 48)};
}

void draw_share(const InterfacePanel& panel, const Columns& at, double share) {
  const app::Palette& palette = panel.look().palette;
  const float height = panel.size(8);
  const float y = std::round(at.bar.middle_y() - 0.5f * height);
  fill({at.bar.x, y, at.bar.width, height}, palette.track);
  fill({at.bar.x, y, std::round(at.bar.width * static_cast<float>(share)), height},
       palette.created);
  std::array<char, 8> text{};
  const auto end = std::to_chars(text.data(), text.data() + 6, std::lround(100 * share)).ptr;
  *end = '%';
  draw_text(panel.look().fonts.text, at.percent, palette.quiet,
            {text.data(), static_cast<std::size_t>(end + 1 - text.data())}, Align::right);
}

void draw_row(const Weights& weights, InterfacePanel& panel, const Box& row, int cycle,
              double share) {
  const auto i = static_cast<std::size_t>(cycle);
  const std::string& target = weights.set().cycles[i].name;
  const Columns at = columns_of(panel, row, weights.has_only());
  panel.line(panel.look().fonts.text, at.name, panel.look().palette.text,
             panel.content().captions.names[i]);
  panel.slide(target, at.slider, weights.sliders()(cycle), slider_start);
  draw_share(panel, at, share);
  if (weights.has_only()) {
    panel.press("only", target, at.only, panel.text("interface.weights.only"));
  }
}

// Back to the middle; and what it means when all are at zero.
void draw_foot(const Weights& weights, InterfacePanel& panel, const Box& foot) {
  const std::string& reset = panel.text("interface.weights.reset");
  const float width = text_width(panel.look().fonts.text, reset) + panel.size(24);
  panel.press("reset", "", {foot.x, foot.y, std::round(width), foot.height}, reset);
  if (weights.sliders().sum() > 0) return;
  const float from = foot.x + width + panel.size(8);
  panel.line(panel.look().fonts.text,
             {from, foot.y, foot.right() - from - panel.size(8), foot.height},
             panel.look().palette.quiet, panel.text("interface.weights.all_zero"));
}

void draw(const InterfaceState& state, InterfacePanel& panel) {
  const auto& weights = static_cast<const Weights&>(state);
  static thread_local Eigen::VectorXd shares;  // scratch: a frame allocates nothing
  weights.weights(panel.now_us(), shares);
  const int rows = weights.set().size();
  // All in sight when there is room for the knobs, else a list that scrolls.
  const float note = panel.size(44);
  const float room = panel.box().height - note;
  const float height =
      std::floor(std::clamp(room / static_cast<float>(rows), panel.size(36), panel.size(48)));
  const Box list{panel.box().x, panel.box().y, panel.box().width, room};
  panel.begin_scroll(list, height * static_cast<float>(rows));
  const ImVec2 origin = ImGui::GetCursorScreenPos();
  for (int k = 0; k < rows; ++k) {
    const int cycle = panel.content().captions.by_name[static_cast<std::size_t>(k)];
    const Box row{origin.x, origin.y + height * static_cast<float>(k), list.width, height};
    draw_row(weights, panel, row, cycle, shares(cycle));
  }
  panel.end_scroll();
  draw_foot(weights, panel, {list.x, list.bottom(), list.width, note});
}

const InterfaceEntry entry{{
    .name = "weights",
    .sentence =
        "A slider for each motion; what is shown is their mixture, each in proportion to its "
        "slider.",
    .parameters = {{.name = "only",
                    .standard = true,
                    .choices = {},
                    .sentence = "true: a button in each row shows that motion alone"}},
    .texts = {"interface.weights.title", "interface.weights.hint", "interface.weights.only",
              "interface.weights.reset", "interface.weights.all_zero"},
    .start = start_as<Weights>,
    .simulate = simulate,
    .draw = draw,
}};

}  // namespace
}  // namespace promenade::app
