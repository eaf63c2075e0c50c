// The list of labels ([N] 6): every motion of the set by its name; one click
// shows it. The simplest interface, and the one that others are compared with.
#include "app/panel.h"
#include "app/registry.h"

namespace promenade::app {
namespace {

using study::Applied;
using study::ControlInput;
using study::InterfacePanel;
using study::InterfaceState;

class Labels final : public InterfaceState {
 public:
  explicit Labels(const study::InterfaceContext& context)
      : set_(&context.space.set),
        start_(context.start),
        sorted_(std::get<bool>(context.parameters.at("sorted"))) {}

  std::unique_ptr<InterfaceState> clone() const override { return std::make_unique<Labels>(*this); }

  Applied apply(const ControlInput& input) override {
    const int cycle = input.kind == "pick" ? motion::find_cycle(*set_, input.target) : -1;
    if (cycle < 0) return Applied::refused;
    picked_ = cycle;
    return Applied::done;
  }

  void weights(std::int64_t, Eigen::VectorXd& weights) const override {
    weights = start_;
    if (picked_ < 0) return;
    weights.setZero();
    weights(picked_) = 1;
  }

  const motion::MotionSet& set() const { return *set_; }
  int picked() const { return picked_; }  // -1: none yet
  bool sorted() const { return sorted_; }

 private:
  const motion::MotionSet* set_;
  Eigen::VectorXd start_;
  bool sorted_;
  int picked_ = -1;
};

std::vector<ControlInput> simulate(const InterfaceState& state, study::Rng& rng) {
  const auto& labels = static_cast<const Labels&>(state);
  std::vector<ControlInput> picks;
  for (int i = 0; i < labels.set().size(); ++i) {
    if (i == labels.picked()) continue;
    picks.push_back(
        {.kind = "pick", .target = labels.set().cycles[static_cast<std::size_t>(i)].name});
  }
  rng.shuffle(picks);
  if (picks.size() > 4) picks.resize(4);  // nobody considers a whole list at once
  return picks;
}

// Which row the arrow keys lead to; -1: none was pressed.
int row_by_key(int row, int rows) {
  const auto pressed = [](ImGuiKey key) { return ImGui::IsKeyPressed(ImGui::GetKeyIndex(key)); };
  if (ImGui::GetIO().WantTextInput) return -1;
  if (pressed(ImGuiKey_DownArrow)) return std::min(row + 1, rows - 1);
  if (pressed(ImGuiKey_UpArrow)) return std::max(row - 1, 0);
  if (pressed(ImGuiKey_Home)) return 0;
  if (pressed(ImGuiKey_End)) return rows - 1;
  return -1;
}

void draw(const InterfaceState& state, InterfacePanel& panel) {
  const auto& labels = static_cast<const Labels&>(state);
  const std::vector<std::string>& names = panel.content().names;
  const int rows = labels.set().size();
  const auto cycle_in = [&](int row) {
    return labels.sorted() ? panel.content().by_name[static_cast<std::size_t>(row)] : row;
  };
  int marked = -1;
  for (int row = 0; row < rows; ++row) {
    if (cycle_in(row) == labels.picked()) marked = row;
  }
  const float height = panel.size(32);
  const float width = panel.begin_scroll(panel.box(), height * static_cast<float>(rows));
  const ImVec2 origin = ImGui::GetCursorScreenPos();
  const auto top = [&](int row) { return origin.y + height * static_cast<float>(row); };
  for (int row = 0; row < rows; ++row) {
    const auto cycle = static_cast<std::size_t>(cycle_in(row));
    panel.row("pick", labels.set().cycles[cycle].name, {origin.x, top(row), width, height},
              names[cycle], row == marked);
  }
  const int wanted = row_by_key(marked, rows);
  if (wanted >= 0 && wanted != marked) {
    panel.report({.kind = "pick",
                  .target = labels.set().cycles[static_cast<std::size_t>(cycle_in(wanted))].name});
    ImGui::SetScrollFromPosY(top(wanted) - ImGui::GetWindowPos().y, 0.5f);
  }
  panel.end_scroll();
}

const InterfaceEntry entry{{
    .name = "labels",
    .sentence = "A list of the names of all motions; a click or the arrow keys show one at once.",
    .parameters = {{.name = "sorted",
                    .standard = true,
                    .choices = {},
                    .sentence = "true: by name; false: in the order of the motion set"}},
    .texts = {"interface.labels.title", "interface.labels.hint"},
    .start =
        [](const study::InterfaceContext& context) { return std::make_unique<Labels>(context); },
    .simulate = simulate,
    .draw = draw,
}};

}  // namespace
}  // namespace promenade::app
